# Fans from first corners; what has fewer than three corners stays.
ravel -q make polygons:cap,size=12,attributes -o cap.ply
ravel -q encode cap.ply -o cap.ravel --keep-order
ravel -q decode cap.ravel -o cap.off --triangulate; echo $?
sed -n 2p cap.off
awk 'NR > 2 && NF == 4 && $1 == 3 {n++} END {print n, "triangles"}' cap.off
