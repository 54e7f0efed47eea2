// Which attributes are what renderers call normals, texture coordinates and colours. Names are those
// of tools/io (obj:vn, off:color, PLY's nx ny nz) and what other programs mostly write.
const ROLES = {
    normal: { names: ['vn', 'normal', 'normals'], parts: [['nx', 'ny', 'nz']], arities: [3] },
    uv: {
        names: ['vt', 'uv', 'uvs', 'texture', 'texcoord', 'texcoords', 'tcoords'],
        parts: [['s', 't'], ['u', 'v'], ['texture_u', 'texture_v']], arities: [2, 3],
    },
    color: {
        names: ['color', 'colors', 'colour', 'rgb', 'rgba'],
        parts: [['red', 'green', 'blue', 'alpha'], ['red', 'green', 'blue']], arities: [3, 4],
    },
};

const bare = (name) => name.slice(name.lastIndexOf(':') + 1).toLowerCase();

// Numbers of an integer type that stand for 0 to 1, as colours do.
function scale_of(type) {
    return { uint8: 1 / 255, uint16: 1 / 65535 }[type] ?? 1;
}

function source_of(attributes, arity) {
    return {
        attributes, arity, place: attributes[0].place,
        // Writes the element's numbers; zeros where it has none.
        read(element, out, at) {
            for (let k = 0; k < arity; ++k) {
                const { values, index, arity: width } = attributes[attributes.length > 1 ? k : 0];
                const tuple = index === undefined ? element : index[element];
                const value = tuple === 0xffffffff ? 0 : values[tuple * width + (attributes.length > 1 ? 0 : k)];
                out[at + k] = Number(value);
            }
        },
    };
}

// {place, arity, scale, read, attributes} on points or corners (corners first), or undefined.
export function find_role(mesh, role) {
    const { names, parts, arities } = ROLES[role];
    const here = (place) => mesh.attributes.filter((attribute) => attribute.place === place);
    for (const place of ['corner', 'point']) {
        const candidates = here(place);
        for (const attribute of candidates) {
            if (!names.includes(bare(attribute.name)) || !arities.includes(attribute.arity)) continue;
            const arity = role === 'uv' ? 2 : attribute.arity;
            return { ...source_of([attribute], arity), scale: role === 'color' ? scale_of(attribute.type) : 1 };
        }
        for (const part_names of parts) {
            const found = part_names.map((name) => candidates.find((a) => bare(a.name) === name && a.arity === 1));
            if (found.some((attribute) => attribute === undefined)) continue;
            return { ...source_of(found, found.length), scale: role === 'color' ? scale_of(found[0].type) : 1 };
        }
    }
    return undefined;
}

// The integer attribute of cells that tells materials or regions apart: a material if there is one,
// else what names its values, else a region by its usual names.
const TAGS = ['material', 'materials', 'physical', 'region', 'ref', 'materialids', 'group', 'geometrical', 'solid'];
export function find_tags(mesh) {
    const is_tag = (a) => a.place === 'cell' && a.arity === 1 && a.index === undefined && /^u?int/.test(a.type);
    const tags = mesh.attributes.filter(is_tag);
    const named = new Set(mesh.tagNames.map((tag) => tag.attribute));
    const rank = (a) => {
        const at = TAGS.indexOf(bare(a.name));
        return at < 0 ? (named.has(a.name) ? TAGS.length : Infinity) : at;
    };
    return tags.filter((a) => rank(a) < Infinity).sort((a, b) => rank(a) - rank(b))[0];
}

// The name of a tag's value; the dimension decides where names are per dimension.
export function name_of_tag(mesh, attribute, value) {
    const dimension = mesh.kind === 'tet' ? 3 : 2;
    const names = mesh.tagNames.filter((tag) => tag.attribute === attribute && tag.value === value);
    return (names.find((tag) => tag.dimension === dimension) ?? names.find((tag) => tag.dimension < 0))?.name;
}
