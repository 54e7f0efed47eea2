// Polygons as triangles. A convex polygon becomes a fan; others lose ears one by one.

// Twice the area of corners a, b, c, seen along the normal.
function turn(points, normal, a, b, c) {
    const o = 3 * a, p = 3 * b, q = 3 * c;
    const ux = points[p] - points[o], uy = points[p + 1] - points[o + 1], uz = points[p + 2] - points[o + 2];
    const vx = points[q] - points[o], vy = points[q + 1] - points[o + 1], vz = points[q + 2] - points[o + 2];
    return normal[0] * (uy * vz - uz * vy) + normal[1] * (uz * vx - ux * vz) + normal[2] * (ux * vy - uy * vx);
}

// Newell's: the areas of the polygon's shadows.
function normal_of(points, corners, first, end, normal) {
    normal.fill(0);
    for (let i = first; i < end; ++i) {
        const p = 3 * corners[i], q = 3 * corners[i + 1 < end ? i + 1 : first];
        for (let axis = 0; axis < 3; ++axis) {
            const u = (axis + 1) % 3, v = (axis + 2) % 3;
            normal[axis] += (points[p + u] - points[q + u]) * (points[p + v] + points[q + v]);
        }
    }
}

// The first corner from which a fan has no triangle turned over, or -1.
function fan_start(points, corners, first, end, normal) {
    const degree = end - first;
    for (let start = 0; start < degree; ++start) {
        let good = true;
        for (let i = 1; good && i + 1 < degree; ++i)
            good = turn(points, normal, corners[first + start], corners[first + ((start + i) % degree)],
                corners[first + ((start + i + 1) % degree)]) >= 0;
        if (good) return start;
        if (degree > 64) return -1;  // trying each corner is quadratic
    }
    return -1;
}

function is_ear(points, corners, normal, ring, i) {
    const n = ring.length, a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    if (turn(points, normal, corners[a], corners[b], corners[c]) <= 0) return false;
    for (const other of ring) {
        const p = corners[other];
        if (p === corners[a] || p === corners[b] || p === corners[c]) continue;
        if (turn(points, normal, corners[a], corners[b], p) >= 0 &&
            turn(points, normal, corners[b], corners[c], p) >= 0 &&
            turn(points, normal, corners[c], corners[a], p) >= 0)
            return false;
    }
    return true;
}

function clip_ears(points, corners, first, end, normal, emit) {
    const ring = [];
    for (let i = first; i < end; ++i) ring.push(i);
    let i = 0;
    for (let tries = 0; ring.length > 3 && tries < ring.length;) {
        const n = ring.length;
        if (is_ear(points, corners, normal, ring, i % n)) {
            emit(ring[(i + n - 1) % n], ring[i % n], ring[(i + 1) % n]);
            ring.splice(i % n, 1);
            tries = 0;
        } else {
            ++i;
            ++tries;
        }
    }
    // What has no ear crosses itself: any fan will do.
    for (let k = 1; k + 1 < ring.length; ++k) emit(ring[0], ring[k], ring[k + 1]);
}

// points: three per triangle; corners: where each stands in polygons.points; cells: the polygon of
// each triangle.
export function triangulate(points, { begin, points: corners }) {
    let count = 0;
    for (let cell = 0; cell + 1 < begin.length; ++cell) count += Math.max(0, begin[cell + 1] - begin[cell] - 2);
    const triangles = {
        points: new Uint32Array(3 * count), corners: new Uint32Array(3 * count), cells: new Uint32Array(count),
    };
    const normal = new Float64Array(3);
    let at = 0, cell = 0;
    const emit = (a, b, c) => {
        triangles.corners[at] = a;
        triangles.corners[at + 1] = b;
        triangles.corners[at + 2] = c;
        triangles.cells[at / 3] = cell;
        at += 3;
    };
    for (; cell + 1 < begin.length; ++cell) {
        const first = begin[cell], end = begin[cell + 1], degree = end - first;
        if (degree < 3) continue;
        if (degree === 3) {
            emit(first, first + 1, first + 2);
            continue;
        }
        normal_of(points, corners, first, end, normal);
        const start = fan_start(points, corners, first, end, normal);
        if (start >= 0 || degree > 1000)
            for (let i = 1; i + 1 < degree; ++i) {
                const from = Math.max(0, start);
                emit(first + from, first + ((from + i) % degree), first + ((from + i + 1) % degree));
            }
        else
            clip_ears(points, corners, first, end, normal, emit);
    }
    for (let i = 0; i < at; ++i) triangles.points[i] = corners[triangles.corners[i]];
    return triangles;
}
