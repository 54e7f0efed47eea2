// Normals of corners: those of the cells around the point that bend less than a crease.
const CREASE = Math.cos((40 * Math.PI) / 180);
// Comparing all cells around a point with each other is quadratic; many cells share one normal.
const MOST_AROUND = 64;

// Newell's normal of each cell, its length twice the area.
export function cell_normals(positions, begin) {
    const normals = new Float32Array(3 * (begin.length - 1));
    for (let cell = 0; cell + 1 < begin.length; ++cell) {
        const first = begin[cell], end = begin[cell + 1];
        let x = 0, y = 0, z = 0;
        for (let i = first; i < end; ++i) {
            const p = 3 * i, q = 3 * (i + 1 < end ? i + 1 : first);
            x += (positions[p + 1] - positions[q + 1]) * (positions[p + 2] + positions[q + 2]);
            y += (positions[p + 2] - positions[q + 2]) * (positions[p] + positions[q]);
            z += (positions[p] - positions[q]) * (positions[p + 1] + positions[q + 1]);
        }
        normals.set([x, y, z], 3 * cell);
    }
    return normals;
}

// Corners [begin[c], begin[c + 1]) of cell c stand at positions[3 * corner] and belong to points[corner].
// Gives four int16 per corner (the fourth is padding), to be normalised by 32767.
export function corner_normals(positions, begin, points, pointCount) {
    const of_cell = cell_normals(positions, begin), corners = points.length;
    const cell_of = new Uint32Array(corners), around_begin = new Uint32Array(pointCount + 1);
    for (let cell = 0; cell + 1 < begin.length; ++cell) cell_of.fill(cell, begin[cell], begin[cell + 1]);
    for (const point of points) ++around_begin[point + 1];
    for (let p = 0; p < pointCount; ++p) around_begin[p + 1] += around_begin[p];
    const around = new Uint32Array(corners), at = around_begin.slice();
    for (let c = 0; c < corners; ++c) around[at[points[c]]++] = c;

    const length = new Float32Array(of_cell.length / 3);
    for (let c = 0; c < length.length; ++c) length[c] = Math.hypot(of_cell[3 * c], of_cell[3 * c + 1], of_cell[3 * c + 2]);
    const result = new Int16Array(4 * corners);
    for (let p = 0; p < pointCount; ++p) {
        const first = around_begin[p], end = around_begin[p + 1], all = end - first > MOST_AROUND;
        for (let i = first; i < end; ++i) {
            const mine = cell_of[around[i]], m = 3 * mine;
            let x = 0, y = 0, z = 0;
            if (!all || i === first) {
                for (let j = first; j < end; ++j) {
                    const other = cell_of[around[j]], o = 3 * other;
                    const dot = of_cell[m] * of_cell[o] + of_cell[m + 1] * of_cell[o + 1] + of_cell[m + 2] * of_cell[o + 2];
                    if (!all && dot < CREASE * length[mine] * length[other]) continue;
                    x += of_cell[o];
                    y += of_cell[o + 1];
                    z += of_cell[o + 2];
                }
                const scale = 32767 / (Math.hypot(x, y, z) || 1);
                result.set([x * scale, y * scale, z * scale], 4 * around[i]);
            } else {
                result.copyWithin(4 * around[i], 4 * around[first], 4 * around[first] + 3);
            }
        }
    }
    return result;
}
