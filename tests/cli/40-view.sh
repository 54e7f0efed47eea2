# What can't be shown is said before anything is served. (tools/viewer/test looks at what is served.)
ravel view missing.obj; echo "missing $?"
ravel view missing.ravel; echo "missing $?"
printf 'no mesh' >broken.ply
ravel view broken.ply; echo "broken $?"
