// The edges of polygons, each once: pairs of points, for THREE.LineSegments. Open addressing,
// linear.
export function edges_of({ begin, points }) {
    let slots = 16;
    while (slots < 2 * points.length) slots *= 2;
    const table = new Int32Array(slots).fill(-1);
    const edges = new Uint32Array(2 * points.length);
    let count = 0;
    for (let cell = 0; cell + 1 < begin.length; ++cell) {
        const first = begin[cell], end = begin[cell + 1];
        for (let i = first; i < end; ++i) {
            const a = points[i], b = points[i + 1 < end ? i + 1 : first];
            if (a === b) continue;
            const low = a < b ? a : b, high = a < b ? b : a;
            let slot = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0;
            slot = (slot ^ (slot >>> 15)) & (slots - 1);
            let edge = table[slot];
            while (edge >= 0 && (edges[edge] !== low || edges[edge + 1] !== high)) {
                slot = (slot + 1) & (slots - 1);
                edge = table[slot];
            }
            if (edge >= 0) continue;
            table[slot] = count;
            edges[count] = low;
            edges[count + 1] = high;
            count += 2;
        }
    }
    return edges.slice(0, count);
}
