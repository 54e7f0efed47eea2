# Every family of recipes comes back equal, bit-exact and on a grid.
recipes="grid grid:triangles,jitter=0.5 torus:size=24x12,double sphere:subdivide=2 moebius terrain:size=30x30,holes=7,double
polygons:hex,size=9x9 polygons:mixed,size=20x20 polygons:cap,size=30 polygons:mixed,attributes,shuffle
tets:box=4 tets:box=4,five,jitter=0.3 tets:ball=4,double tets:shell=8 tets:box=3,copies=3,shuffle,attributes,companions"
for recipe in $recipes $(ravel make --list | sed -n 's/^tiny:NAME *//p' | sed 's/\(^\| \)/ tiny:/g'); do
    ending=vtu
    ravel -q make "$recipe" -o mesh.$ending -f || { echo "make $recipe: $?"; continue; }
    for options in "" "--position-bits 11" "--keep-order"; do
        ravel verify mesh.$ending $options --json >report 2>why
        code=$?
        grep -q '"equal": true' report && [ $code = 0 ] || echo "$recipe $options: exit $code: $(cat why)"
    done
done
echo done
