// The viewer's page in a browser: what it shows, what it says, and that it asks nobody.
//     viewer_test.mjs PACKAGE RAVEL FOLDER [PICTURES]
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

import { colourful, covered, difference, launch, new_page, open_file, picture, set, settled, share } from './browser.mjs';

const [, , dist, ravel, folder, pictures] = process.argv;
const PAGE = pathToFileURL(path.join(dist, 'viewer.html')).href;
const run = (...words) => execFileSync(ravel, ['-q', ...words], { stdio: ['ignore', 'pipe', 'inherit'] }).toString();

function make(name, recipe, ending, ...options) {
    const mesh = path.join(folder, `${name}.${ending}`);
    run('make', recipe, '-o', mesh, '--force');
    run('encode', mesh, '-o', path.join(folder, `${name}.ravel`), '--force', ...options);
    return path.join(folder, `${name}.ravel`);
}

let browser, quads, tets;
before(async () => {
    quads = make('torus', 'torus:quads=6000,bumps=0.15,attributes', 'ply', '--position-bits', '14');
    tets = make('shell', 'tets:ball=9,attributes', 'msh');
    browser = await launch();
});
after(() => browser?.close());

async function with_page(options, work) {
    const page = await new_page(browser, options);
    try {
        await work(page);
        assert.deepEqual(page.trouble, []);
    } finally {
        await page.context().close();
    }
}

test('a quad mesh: shown, wound off, with its curve, plain and by its data', () => with_page({}, async (page) => {
    await page.context().setOffline(true);
    await page.goto(PAGE);
    assert.match(await page.textContent('#drop'), /Drop a \.ravel file/);
    await open_file(page, quads);
    assert.match(await page.textContent('#what'), /^5,995 polygons/);
    const whole = await picture(page);
    assert(covered(whole) > 0.1 && share(whole, colourful) > 0.08, 'the mesh is there, in colours');

    await set(page, 'wind', 0.5);
    const half = await picture(page);
    assert(difference(whole, half) > 0.03);
    assert(share(half, colourful) < 0.75 * share(whole, colourful), 'half of it has lost its colours');
    assert(covered(half) > 0.9 * covered(whole), 'but is still there as a shadow');
    await page.click('#rest');
    await settled(page);
    assert(covered(await picture(page)) < 0.85 * covered(whole));
    await set(page, 'wind', 0);
    assert.equal(covered(await picture(page)), 0, 'nothing wound, nothing shown');
    await set(page, 'wind', 1);
    assert(difference(whole, await picture(page)) < 0.001, 'wound on again it is as it was');

    for (const id of ['curve', 'edges']) {
        const without = await picture(page);
        await page.click(`#${id}`);
        await settled(page);
        assert(difference(without, await picture(page)) > 0.01, id);
    }
    await page.click('text=Flat');
    await settled(page);
    const flat = await picture(page);
    await page.selectOption('#colour', 'plain');
    await settled(page);
    const plain = await picture(page);
    assert(share(plain, colourful) < 0.01 && difference(flat, plain) > 0.05);

    const fields = await page.locator('#colour option').allTextContents();
    assert(fields.length > 4, `only ${fields}`);
    for (const field of fields.slice(2)) {
        await page.selectOption('#colour', { label: field });
        await settled(page);
        assert(share(await picture(page), colourful) > 0.02, field);
        assert((await page.textContent('#legend')).includes(field), field);
    }
    assert(page.asked.every((url) => /^(file|blob|data):/.test(url)), `${page.asked}`);
}));

test('the strip winds by itself, and stops', () => with_page({}, async (page) => {
    await page.goto(PAGE);
    await open_file(page, quads);
    await page.locator('#canvas').focus();
    await page.keyboard.press('Space');
    // All is wound until the first frame takes it back to the start.
    await page.waitForFunction(() => {
        const at = document.getElementById('wind');
        return Number(at.value) > 50 && Number(at.value) < Number(at.max);
    });
    assert.equal(await page.getAttribute('#play', 'aria-pressed'), 'true');
    await page.keyboard.press('Space');
    const stopped = Number(await page.inputValue('#wind'));
    await page.waitForTimeout(200);
    assert.equal(Number(await page.inputValue('#wind')), stopped);
    await page.keyboard.press('.');
    assert.equal(Number(await page.inputValue('#wind')), stopped + 1);
    await page.keyboard.press('0');
    assert.match(await page.textContent('#live'), /^100 percent wound/);
}));

test('tets: cut through whole cells, shrunk, and with the curve inside', () => with_page({}, async (page) => {
    await page.goto(PAGE);
    await open_file(page, tets);
    assert(await page.isVisible('#volume'));
    const whole = await picture(page);
    assert(share(whole, colourful) > 0.08);
    await page.click('#clip');
    await settled(page);
    const cut = await picture(page);
    assert(difference(whole, cut) > 0.03 && covered(cut) < 0.95 * covered(whole), `a part is gone: ${covered(cut)} of ${covered(whole)}`);
    await page.click('text=Flip');
    await settled(page);
    const other = await picture(page);
    assert(difference(cut, other) > 0.05, 'the other part');
    await page.keyboard.press('z');
    await settled(page);
    assert(difference(other, await picture(page)) > 0.05, 'across another axis');
    await set(page, 'clip-at', 0);
    const all_gone = covered(await picture(page));
    await page.click('#flip');
    await settled(page);
    assert(Math.abs(covered(await picture(page)) - all_gone) > 0.1, 'all of it on one side of a cut at the end');
    await page.click('#clip');
    await set(page, 'shrink', 0.5);
    const shrunk = await picture(page);
    assert(difference(whole, shrunk) > 0.05);
    await set(page, 'wind', 0.5);
    assert(difference(shrunk, await picture(page)) > 0.02);
    await set(page, 'shrink', 0);
    await page.click('#curve');
    await settled(page);
    const curve = await picture(page);
    await set(page, 'wind', 0.25);
    assert(difference(curve, await picture(page)) > 0.01);
    for (const field of (await page.locator('#colour option').allTextContents()).slice(2)) {
        await page.selectOption('#colour', { label: field });
        await settled(page);
        assert((await page.textContent('#legend')).includes(field), field);
    }
}));

test('a broken file: code, place and sentence as the tool says them; the mesh before stays', () => with_page({}, async (page) => {
    const bytes = fs.readFileSync(quads);
    bytes[bytes.length - 100] ^= 1;
    const broken = path.join(folder, 'broken.ravel');
    fs.writeFileSync(broken, bytes);
    await page.goto(PAGE);
    await open_file(page, broken);
    const told = await page.locator('#broken').innerText();
    assert.equal(await page.getAttribute('#broken', 'role'), 'alert');
    let complaint = '';
    try {
        execFileSync(ravel, ['verify', broken], { stdio: 'pipe' });
    } catch (error) {
        complaint = error.stderr.toString();
    }
    const [, detail, code, at] = complaint.match(/: ([^:]+) \((\w+), byte (\d+)\)/);
    assert(told.includes(code) && told.replaceAll(',', '').includes(`byte ${at}`) && told.toLowerCase().includes(detail.toLowerCase()), `${told} / ${complaint}`);
    await open_file(page, quads);
    assert(await page.isHidden('#broken'));
    const before_it = await picture(page);
    await open_file(page, broken);
    await page.click('text=Back to the mesh');
    assert(difference(before_it, await picture(page)) < 0.001);
    await open_file(page, path.join(folder, 'torus.ply'));
    assert.match(await page.locator('#broken').innerText(), /ravel encode torus\.ply -o torus\.ravel/);
    fs.writeFileSync(path.join(folder, 'empty.ravel'), '');
    await open_file(page, path.join(folder, 'empty.ravel'));
    assert.match(await page.locator('#broken').innerText(), /not_a_ravel_file/);
}));

test('every tiny mesh and every soup opens', () => with_page({}, async (page) => {
    await page.goto(PAGE);
    const recipes = ['tiny:empty', 'tiny:empty-tets', 'tiny:points', 'tiny:degrees-0-1-2', 'tiny:point-cell', 'tiny:flat-tet', 'tiny:tets-both-sides',
        'tiny:both-sides', 'soup:polygons=200,attributes', 'soup:tets=200,attributes,companions', 'polygons:cap,size=9', 'tiny:triangle'];
    for (const [i, recipe] of recipes.entries()) {
        await open_file(page, make(`any${i}`, recipe, recipe.includes('tet') ? 'msh' : 'ply'));
        assert(await page.isHidden('#broken'), `${recipe}: ${await page.locator('#broken').innerText()}`);
        await set(page, 'wind', 0.5);
    }
    assert(share(await picture(page), colourful) > 0.02, 'a triangle is in view');
}));

test('a dropped file opens', () => with_page({}, async (page) => {
    await page.goto(PAGE);
    const transfer = await page.evaluateHandle(async (text) => {
        const transfer_ = new DataTransfer(), bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        transfer_.items.add(new File([bytes], 'dropped.ravel'));
        return transfer_;
    }, fs.readFileSync(tets).toString('base64'));
    await page.dispatchEvent('#stage', 'dragenter', { dataTransfer: transfer });
    assert(await page.isVisible('#hover'));
    await page.dispatchEvent('#stage', 'drop', { dataTransfer: transfer });
    await page.waitForFunction(() => document.getElementById('name').textContent === 'dropped.ravel');
    assert(await page.isHidden('#hover'));
}));

test('keys, names and order for those who do not see or point', () => with_page({ reducedMotion: 'reduce' }, async (page) => {
    await page.goto(PAGE);
    await open_file(page, tets);
    assert.match(await page.textContent('#live'), /shell\.ravel: [\d,]+ tets, [\d,]+ points/);
    const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input:not([type=file]), select, canvas, dialog, section')]
        .filter((node) => !(node.getAttribute('aria-label') || node.getAttribute('aria-labelledby') || node.labels?.[0]?.textContent.trim() || node.textContent.trim()))
        .map((node) => node.outerHTML));
    assert.deepEqual(nameless, []);
    await page.evaluate(() => document.activeElement.blur());
    const visited = [];
    for (let i = 0; i < 10; ++i) {
        await page.keyboard.press('Tab');
        visited.push(await page.evaluate(() => document.activeElement.id || document.activeElement.className));
    }
    assert.deepEqual(visited, ['skip', 'open', 'help', 'canvas', 'play', 'wind', 'colour', '', '', 'edges']);
    await page.locator('#canvas').focus();
    const front = await picture(page);
    for (let i = 0; i < 6; ++i) await page.keyboard.press('ArrowLeft');
    await settled(page);
    const turned = await picture(page);
    assert(difference(front, turned) > 0.03, 'arrow keys turn it');
    await page.keyboard.press('f');
    await settled(page);
    assert(difference(front, await picture(page)) < 0.001, 'F brings it back');
    await page.keyboard.press('t');
    await settled(page);
    assert(difference(front, await picture(page)) > 0.03, 'T turns another side up');
    await page.keyboard.press('?');
    assert(await page.isVisible('#keys'));
    assert((await page.locator('#key-list dt').count()) > 12);
    await page.keyboard.press('Escape');
    assert(await page.isHidden('#keys'));
    assert.equal(await page.evaluate(() => getComputedStyle(document.getElementById('edges')).transitionDuration), '0s');
}));

test('a phone-wide window: nothing is cut off, the winding stays in reach', () =>
    with_page({ viewport: { width: 375, height: 720 }, isMobile: true, hasTouch: true, colorScheme: 'dark' }, async (page) => {
        await page.goto(PAGE);
        await open_file(page, tets);
        const { wide, dark } = await page.evaluate(() => ({ wide: document.documentElement.scrollWidth, dark: getComputedStyle(document.body).backgroundColor }));
        assert.equal(wide, 375);
        assert(dark.match(/\d+/g).every((part) => Number(part) < 60), `dark is asked for: ${dark}`);
        assert(covered(await picture(page)) > 0.1);
        await page.locator('#sections').scrollIntoViewIfNeeded();
        const box = await page.locator('#transport').boundingBox();
        assert(box.y >= 0 && box.y + box.height <= 721, `the winding bar is at ${box.y}`);
        const small = await page.evaluate(() => [...document.querySelectorAll('header button, #play, select, .segments span')]
            .filter((node) => node.offsetParent && node.getBoundingClientRect().height < 32).map((node) => node.outerHTML));
        assert.deepEqual(small, [], 'too small to touch');
    }));

test('ravel view serves the page and the mesh, to this machine only, until it is stopped', () => with_page({}, async (page) => {
    const server = spawn(ravel, ['view', path.join(folder, 'shell.msh')]);
    let said = '';
    const ended = new Promise((done) => server.once('exit', (code, signal) => done(signal ?? code)));
    try {
        const url = await new Promise((done, fail) => {
            server.stdout.on('data', (text) => { said += text; if (said.includes('\n')) done(said.trim()); });
            server.once('exit', () => fail(new Error('it ended')));
        });
        assert.match(url, /^http:\/\/127\.0\.0\.1:\d+\/$/);
        await page.goto(url);
        await page.waitForFunction(() => document.getElementById('name').textContent === 'shell.msh');
        assert.equal((await fetch(`${url}mesh.ravel`)).status, 200);
        assert.equal((await fetch(`${url}../shell.msh`)).status, 404);
        assert.equal((await fetch(url, { method: 'POST' })).status, 405);
        const asked_as = (host) => new Promise((done) => http.get(`${url}mesh.ravel`, { headers: { host } }, (answer) => { answer.resume(); done(answer.statusCode); }));
        assert.equal(await asked_as('elsewhere.example'), 421, 'a name that was bent to this address');
        assert(page.asked.every((asked) => asked.startsWith(url) || /^(blob|data):/.test(asked)), `${page.asked}`);
    } finally {
        server.kill('SIGINT');
    }
    assert.equal(await ended, 'SIGINT');
}));

test('ravel compare --html: the meshes, Ravel and its peers in one page', () => with_page({}, async (page) => {
    const file = path.join(folder, 'compared.html');
    fs.writeFileSync(path.join(folder, '<b>"x".ply'), fs.readFileSync(path.join(folder, 'torus.ply')));
    run('compare', path.join(folder, '<b>"x".ply'), path.join(folder, 'shell.msh'), '--position-bits', '14', '--html', file);
    await page.goto(pathToFileURL(file).href);
    await page.waitForFunction(() => document.getElementById('name').textContent === '<b>"x"');
    assert(await page.isVisible('#peers'));
    const rows = await page.locator('#peer-rows tbody th').allTextContents();
    for (const codec of ['ravel', 'draco-triangles', 'draco-polygons', 'zstd', 'xz']) assert(rows.some((row) => row.startsWith(codec)), codec);
    await page.selectOption('#files', '1');
    await page.waitForFunction(() => document.getElementById('name').textContent === 'shell');
    await page.click('#numbers-open');
    assert((await page.locator('#all-rows tbody tr').count()) >= 14);
    assert.match(await page.textContent('#all-rows'), /geometric mean/);
}));

test('RavelLoader in a page: workers, groups, a broken file', () => with_page({}, async (page) => {
    const types = { '.mjs': 'text/javascript', '.js': 'text/javascript', '.html': 'text/html', '.ravel': 'application/octet-stream' };
    const html = `<!doctype html><script type="importmap">{"imports": {"three": "/node_modules/three/build/three.module.js"}}</script>`;
    const server = http.createServer((request, response) => {
        const name = decodeURIComponent(request.url), place = [dist, path.dirname(dist), folder].map((root) => path.join(root, name)).find((file) => fs.existsSync(file) && fs.statSync(file).isFile());
        response.writeHead(name === '/' || place ? 200 : 404, { 'content-type': types[path.extname(name || '.html')] ?? 'text/html' });
        response.end(name === '/' ? html : place ? fs.readFileSync(place) : '');
    }).listen(0, '127.0.0.1');
    await new Promise((done) => server.once('listening', done));
    try {
        await page.goto(`http://127.0.0.1:${server.address().port}/`);
        const found = await page.evaluate(async () => {
            const { RavelLoader } = await import('/RavelLoader.mjs');
            const loader = new RavelLoader().setDecoderPath('/').setWorkerLimit(2).preload();
            let progressed = false;
            const both = await Promise.all(['/torus.ravel', '/shell.ravel', '/torus.ravel'].map((url) => loader.loadAsync(url, () => { progressed = true; })));
            const error = await loader.parseAsync(new Uint8Array(8)).catch((caught) => caught);
            const in_page = await new RavelLoader().setDecoderPath('/').setWorkerLimit(0).loadAsync('/torus.ravel');
            const beside = await new RavelLoader().loadAsync('/torus.ravel');
            const sizes = (geometry) => [geometry.getAttribute('position').count, geometry.index.count, geometry.edges.index.count, geometry.ravel.kind];
            const workers = loader.workers.length;
            loader.dispose();
            return { both: both.map(sizes), code: error.code, in_page: sizes(in_page), beside: sizes(beside), workers, left: loader.workers.length, progressed };
        });
        assert.deepEqual(found.both[0], found.both[2]);
        assert.deepEqual(found.both[0], found.in_page);
        assert.deepEqual(found.both[0], found.beside);
        assert.equal(found.both[0][3], 'polygon');
        assert.equal(found.both[1][3], 'tet');
        assert(found.both[1][1] > 1000 && found.both[1][2] === found.both[1][1]);
        assert.deepEqual([found.code, found.workers, found.left, found.progressed], ['not_a_ravel_file', 2, 0, true]);
    } finally {
        server.close();
    }
}));

// The README's pictures.
test('pictures', { skip: pictures === undefined }, async () => {
    const shot = async (name, recipe, ending, work) => with_page({ viewport: { width: 800, height: 500 } }, async (page) => {
        await page.goto(PAGE);
        await open_file(page, make(name, recipe, ending, '--position-bits', '14'));
        await work(page);
        await page.evaluate(() => document.activeElement.blur());
        const picture_path = path.join(pictures, `${name}.png`);
        await page.screenshot({ path: picture_path });
        execFileSync('zopflipng', ['-y', picture_path, picture_path]);
        assert(fs.statSync(picture_path).size < 150_000);
    });
    await shot('strip', 'torus:quads=2400,bumps=0.2', 'ply', async (page) => {
        await page.click('#curve');
        await set(page, 'wind', 0.62);
    });
    await shot('tets', 'tets:shell=9,jitter=0.1', 'msh', async (page) => {
        await set(page, 'clip-at', 0.5);
        await set(page, 'shrink', 0.25);
    });
});
