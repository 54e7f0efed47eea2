// Where files come from: what the page was given, what the user opens or drops.
const MAGIC = [0x52, 0x61, 0x76, 0x31];  // "Rav1"
const MESHES = /\.(obj|off|ply|stl|msh|mesh|vtk|vtu|node|ele)$/i;

// {files: [{name, data (base64) or url, rows}]}, or null.
export function given() {
    return JSON.parse(document.getElementById('ravel-data').textContent);
}

async function read_stream(response, progress) {
    const size = Number(response.headers.get('content-length')) || 0, pieces = [], reader = response.body.getReader();
    let read = 0;
    for (;;) {
        const { done, value } = await reader.read();
        if (done) break;
        pieces.push(value);
        progress(read += value.length, size);
    }
    const bytes = new Uint8Array(read);
    read = 0;
    for (const piece of pieces) {
        bytes.set(piece, read);
        read += piece.length;
    }
    return bytes;
}

// The bytes of a file that was given, dropped or chosen.
export async function bytes_of(file, progress) {
    if (file.data !== undefined) return Uint8Array.from(atob(file.data), (letter) => letter.charCodeAt(0));
    if (file.url !== undefined) {
        const response = await fetch(file.url);
        if (!response.ok) throw new Error(`the file can't be fetched: the server says ${response.status}`);
        return read_stream(response, progress);
    }
    return read_stream(new Response(file.stream(), { headers: { 'content-length': file.size } }), progress);
}

// Words for a file that is a mesh, but not packed; undefined for all others.
export function words_for_mesh(name, bytes) {
    if (!MESHES.test(name) || MAGIC.every((byte, i) => bytes[i] === byte)) return undefined;
    return { detail: 'This page opens .ravel files. Pack the mesh first, or let the tool do it:',
        commands: [`ravel encode ${name} -o ${name.replace(/\.[^.]*$/, '')}.ravel`, `ravel view ${name}`] };
}

export function watch_drops(open) {
    let depth = 0;
    const over = (on) => document.body.classList.toggle('dragging', on);
    addEventListener('dragenter', (event) => { event.preventDefault(); over(++depth > 0); });
    addEventListener('dragleave', () => over(--depth > 0));
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener('drop', (event) => {
        event.preventDefault();
        over((depth = 0) > 0);
        const [file] = event.dataTransfer.files;
        if (file) open(file);
    });
}
