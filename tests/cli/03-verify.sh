# Verify says equal, says whether order was kept, and its keys are the contract's.
ravel -q make sphere:subdivide=3,bumps=0.2 -o sphere.ply
ravel verify sphere.ply --json | sed 's/"bytes": .*/"bytes": N/'
ravel verify sphere.ply --keep-order --json | grep order_kept
ravel verify sphere.ply --position-bits 12 | grep '^equal'
ravel verify sphere.ply --max-error 0.001 --json >report; grep '"equal"' report
python3 - <<'P'
import json
report = json.load(open("report"))
print("bound kept", report["max_error"] <= report["bound"] <= 0.001)
P
ravel -q make torus:quads=200,double -o double.vtk
ravel verify double.vtk --float32 --json >report; grep '"equal"' report
python3 -c 'import json; r = json.load(open("report")); print("rounding told", 0 < r["max_error"] <= r["bound"] < 1e-6)'
