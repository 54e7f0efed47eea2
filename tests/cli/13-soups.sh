# Random soups with every kind of dirt come back equal.
for seed in $(seq 1 25); do
    for kind in polygons tets; do
        ravel -q make soup:$kind=60,seed=$seed -o soup.vtu -f || echo "make $kind $seed: $?"
        for options in "" "--position-bits 10" "--keep-order"; do
            ravel -q verify soup.vtu $options --json >report 2>why || echo "$kind $seed $options: $(cat why)"
        done
        ravel -q strip soup.vtu --json >report 2>why || echo "strip $kind $seed: $(cat why)"
    done
done
echo done
