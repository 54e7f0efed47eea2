// Files for the tests: every family of `ravel make`, every way to store positions, real meshes where
// there are some, and the vectors of the specification.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const RECIPES = [
    'grid:size=30x20', 'grid:size=20x20,triangles,jitter=0.3', 'torus:quads=3000,attributes',
    'torus:quads=2000,double,shuffle,copies=3', 'sphere:subdivide=4,bumps=0.2', 'moebius:size=40x4',
    'terrain:size=60x60,holes=50,attributes', 'polygons:hex', 'polygons:mixed', 'polygons:cap,size=9',
    'tets:box=8x7x6,attributes', 'tets:box=6x6x6,five,jitter=0.2', 'tets:ball=8,companions,double',
    'tets:shell=8,shuffle', 'soup:polygons=200,attributes', 'soup:tets=200,attributes,companions',
];
const TINY = ('empty empty-tets points tet-points triangle quad digon degrees-0-1-2 two-quads two-apart twice ' +
    'both-sides flipped fan-of-three pinch bow-tie point-cell cube tet two-tets tets-twice tets-both-sides ' +
    'tets-on-one-face tets-on-one-edge tets-on-one-point flat-tet').split(' ');
const OPTIONS = [[], ['--position-bits', '12'], ['--keep-order']];

function find(folder, ending) {
    if (!fs.existsSync(folder)) return [];
    return fs.readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(ending))
        .map((name) => path.join(folder, name)).sort();
}

// Writes .ravel files into `folder`; gives their paths.
export function make_files(ravel, folder, corpus) {
    const run = (...words) => execFileSync(ravel, ['-q', ...words], { stdio: ['ignore', 'pipe', 'inherit'] });
    const files = [];
    const encode = (mesh, name, options) => {
        const file = path.join(folder, `${name}.ravel`);
        run('encode', mesh, '-o', file, '--force', ...options);
        files.push(file);
    };
    const recipes = [...RECIPES, ...TINY.map((name) => `tiny:${name}`)];
    recipes.forEach((recipe, i) => {
        const mesh = path.join(folder, `mesh${i}.msh`);
        // Attributes on corners have no place in MSH.
        const kept = recipe.includes('tet') ? mesh : mesh.replace('.msh', '.ply');
        run('make', recipe, '-o', kept, '--force');
        OPTIONS.forEach((options, k) => encode(kept, `${recipe.replace(/[:,=]/g, '-')}-${k}`, options));
    });
    if (corpus && fs.existsSync(corpus)) {
        const names = ['quad/suzanne.obj', 'quad/sh_sofa3.obj', 'quad/spot_quadrangulated.obj',
            'tet/fandisk_22k.node', 'tet/polyfem_microstructure_P2.msh', 'tet/sfepy_elbow2.mesh'];
        for (const name of names)
            encode(path.join(corpus, name), path.basename(name), name.startsWith('quad') ? [] : OPTIONS[1]);
    }
    return files;
}

export function find_vectors(root) {
    return find(path.join(root, 'spec', 'vectors'), '.ravel');
}

export function find_findings(root) {
    const folder = path.join(root, 'tests', 'fuzz', 'found', 'decode');
    return fs.existsSync(folder) ? fs.readdirSync(folder).map((name) => path.join(folder, name)) : [];
}
