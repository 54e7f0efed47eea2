// Broken files: cut, changed, and changed with checksums that fit, so that the decoder behind them
// is reached.

// A small generator, the same on every machine.
export function random_of(seed) {
    let state = seed >>> 0;
    return (below) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return Math.floor((state / 2 ** 32) * below);
    };
}

function crc32c(bytes) {
    let c = ~0;
    for (const byte of bytes) {
        c ^= byte;
        for (let k = 0; k < 8; ++k) c = (c >>> 1) ^ (c & 1 ? 0x82f63b78 : 0);
    }
    return ~c >>> 0;
}

// Where each section's bytes are (spec/format.md, container).
function sections_of(file) {
    const sections = [];
    let at = 6;
    const varint = () => {
        let value = 0, factor = 1;
        for (;;) {
            const byte = file[at++];
            value += (byte & 127) * factor;
            factor *= 128;
            if (byte < 128) return value;
        }
    };
    while (at < file.length - 4) {
        const size = varint(), packed = size % 2 === 1;
        if (packed) varint();
        const length = Math.floor(size / 2);
        sections.push({ at, length, packed });
        at += length;
    }
    return sections;
}

export function damaged(file, count, seed) {
    const random = random_of(seed), results = [];
    const sections = sections_of(file).filter((section) => section.length > 0);
    for (let i = 0; i < count; ++i) {
        const kind = i % 4;
        if (kind === 0) {
            results.push(file.slice(0, random(file.length)));
            continue;
        }
        const copy = file.slice();
        if (kind === 1) {
            copy[random(copy.length)] ^= 1 << random(8);
        } else {
            const section = sections[random(sections.length)];
            for (let k = random(3); k >= 0; --k)
                copy[section.at + random(section.length)] = random(2) ? random(256) : 255;
            const end = copy.length - 4, sum = crc32c(copy.subarray(0, end));
            new DataView(copy.buffer, copy.byteOffset).setUint32(end, sum, true);
        }
        results.push(copy);
    }
    return results;
}
