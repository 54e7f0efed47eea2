# Whenever a run is ended, the output is the old file or the whole new one, and nothing else is left
# behind; only SIGKILL may leave a hidden folder.
ravel -q make tets:box=24 -o box.vtk
ravel -q encode box.vtk -o whole.ravel
ravel -q decode whole.ravel -o whole.msh
whole() { cmp -s "$1" "$2" || [ "$(cat "$1")" = old ]; }
for signal in INT TERM HUP KILL; do
    for hundredths in 0 1 2 3 5 8 12 20 30; do
        echo old >out.ravel
        echo old >out.msh
        # A job in the background ignores SIGINT unless it is asked not to.
        env --default-signal=INT ravel -q encode box.vtk -o out.ravel -f 2>/dev/null &
        first=$!
        env --default-signal=INT ravel -q decode whole.ravel -o out.msh -f 2>/dev/null &
        second=$!
        sleep "$(printf '0.%02d' "$hundredths")"
        kill -$signal $first $second 2>/dev/null
        wait $first $second 2>/dev/null
        whole out.ravel whole.ravel || echo "SIG$signal after $hundredths: half a .ravel file"
        whole out.msh whole.msh || echo "SIG$signal after $hundredths: half a mesh"
        [ $signal = KILL ] || ls -A | grep '^\.ravel-'
        rm -rf .ravel-*
    done
done
ls -A
# A signal's own exit code tells who ended the run.
for signal in INT TERM; do
    env --default-signal=INT ravel -q decode - -o x.obj < <(sleep 5) &
    run=$!
    sleep 0.2
    kill -$signal $run
    wait $run 2>/dev/null
    echo "SIG$signal: $?"
done
