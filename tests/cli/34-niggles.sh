# With the mesh on stdout, facts that were asked for go to stderr.
ravel -q make torus:quads=200 -o torus.obj
ravel -q strip torus.obj --json -o - --to obj >mesh.obj 2>facts.json
grep -c '^f ' mesh.obj
grep -e '"strips"' -e '"cells"' facts.json
ravel -q strip torus.obj -o - --to obj 2>&1 >/dev/null | wc -l
# An empty file is an empty mesh, which is worth a remark.
: >nothing.obj
ravel encode nothing.obj -o nothing.ravel; echo $?
ravel -q verify nothing.obj | grep '^equal'
# Meshes of one name are told apart by their paths.
mkdir one two
ravel -q make torus:quads=100 -o one/t.obj
ravel -q make torus:quads=300 -o two/t.obj
ravel -q compare one/t.obj two/t.obj torus.obj one/t.obj --codecs zstd --csv | cut -d, -f1,2
