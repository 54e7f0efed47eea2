# A cut or damaged file: the section, and the byte.
ravel -q make tets:box=6,attributes,companions -o box.vtk
ravel -q encode box.vtk -o whole.ravel --keep-order
size=$(stat -c %s whole.ravel)
for percent in 0 1 20 50 95 99; do
    head -c $((size * percent / 100)) whole.ravel >cut.ravel
    ravel verify cut.ravel 2>err >out; code=$?
    echo "$code $(wc -c <out) $(sed -e "s/[0-9][0-9]*/N/g" -e "s/section .*\" (/a section (/" err)"
done
head -c $((size - 1)) whole.ravel >cut.ravel
ravel -q verify cut.ravel 2>&1 | sed "s/byte $((size - 1))/the last byte/"
for percent in 3 30 60 97; do
    cp whole.ravel changed.ravel
    at=$((size * percent / 100))
    printf '\125\252\125' | dd of=changed.ravel bs=1 seek=$at conv=notrunc 2>/dev/null
    ravel -q verify changed.ravel 2>/dev/null >out; echo "$? $(wc -c <out)"
done
ravel -q verify whole.ravel | grep -e equal -e order
ls -A
