// Where a mesh is: drawn coordinates are 32-bit and relative to the middle, so that meshes far from the
// origin keep their shape. Points that are not finite are left out of the box and drawn in its middle.
export function frame_of(points) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; i += 3) {
        if (!(Math.abs(points[i]) + Math.abs(points[i + 1]) + Math.abs(points[i + 2]) < 1e30)) continue;
        for (let k = 0; k < 3; ++k) {
            if (points[i + k] < low[k]) low[k] = points[i + k];
            if (points[i + k] > high[k]) high[k] = points[i + k];
        }
    }
    const empty = !(low[0] <= high[0]);
    const middle = empty ? [0, 0, 0] : low.map((x, k) => (x + high[k]) / 2);
    const half = empty ? [1, 1, 1] : high.map((x, k) => (x - low[k]) / 2);
    // Drawn in units of the largest half extent: the same camera and lights suit a cell and a continent.
    const unit = Math.max(...half) || 1;
    return { middle, unit, half: half.map((x) => x / unit) };
}

export function drawn(points, { middle, unit }) {
    const result = new Float32Array(points.length);
    for (let i = 0; i < points.length; ++i) {
        const x = (points[i] - middle[i % 3]) / unit;
        result[i] = Math.abs(x) < 1e6 ? x : 0;
    }
    return result;
}
