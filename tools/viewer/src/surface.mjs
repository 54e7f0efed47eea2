// Boundary triangles come as the tets' facets in VTK's order; a tet of negative volume has them
// inside out.
export function turn_outwards(mesh) {
    const { points, tets } = mesh, { points: corners, facets } = mesh.surface;
    for (let f = 0; f < facets.length; ++f) {
        const tet = facets[f] & ~3;
        const a = 3 * tets[tet], b = 3 * tets[tet + 1], c = 3 * tets[tet + 2], d = 3 * tets[tet + 3];
        const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
        const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
        const wx = points[d] - points[a], wy = points[d + 1] - points[a + 1], wz = points[d + 2] - points[a + 2];
        const volume = ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx);
        if (volume < 0) {
            const kept = corners[3 * f + 1];
            corners[3 * f + 1] = corners[3 * f + 2];
            corners[3 * f + 2] = kept;
        }
    }
}
