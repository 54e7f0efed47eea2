# What can't be written is no success, and a mesh is not overwritten by its own file.
ravel -q make torus:quads=200 -o torus.obj
ravel -q info torus.obj >/dev/full 2>&1; echo "not a ravel file $?"
ravel -q verify torus.obj >/dev/full; echo "full disk $?"
ravel -q make --list >/dev/full; echo "full disk $?"
ravel -q encode torus.obj -o torus.obj --force; echo "onto itself $?"
ravel -q encode torus.obj -o torus.ravel --max-error nan; echo "no number $?"
ravel -q encode torus.obj -o torus.ravel --max-error 0; echo "no error at all $?"
ravel -q encode torus.obj -o torus.ravel --strip-budget nan; echo "no budget $?"
printf '\357\273\277v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n' >bom.obj
ravel -q encode bom.obj -o bom.ravel && ravel -q decode bom.ravel -o - --to obj | grep -c '^v '
