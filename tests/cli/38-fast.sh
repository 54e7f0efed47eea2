# --fast looks for no parts that repeat: a dozen like hills are larger with it and come back as well.
ravel -q make terrain:size=20x20,copies=12 -o hills.ply
ravel -q encode hills.ply -o small.ravel
ravel -q encode hills.ply -o fast.ravel --fast; echo "fast $?"
[ $(wc -c <fast.ravel) -gt $(wc -c <small.ravel) ] && echo "larger"
ravel -q verify hills.ply --fast | grep "^equal"
ravel -q encode hills.ply -o alone.ravel --threads 1; ravel -q encode hills.ply -o many.ravel --threads 3
cmp alone.ravel small.ravel && cmp many.ravel small.ravel && echo "the same with any threads"
for n in 0 1025 all; do ravel encode hills.ply -o x.ravel --threads $n >out 2>err; echo "threads $n $?"; done
ravel encode hills.ply -o x.ravel --fast --level 3 >out 2>err; echo "both $?"
