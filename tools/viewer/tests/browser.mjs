// A browser without a window, and what its pictures say.
import fs from 'node:fs';
import { chromium } from 'playwright-core';

const WHERE = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'];

export async function launch() {
    const executablePath = WHERE.find((path) => fs.existsSync(path));
    if (executablePath === undefined) throw new Error('no chromium: tools/install-deps installs it');
    return chromium.launch({
        executablePath,
        args: ['--no-sandbox', '--disable-gpu', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
            '--disable-background-networking', '--no-first-run', '--disable-component-update', '--disable-sync'],
    });
}

// A page that remembers what went wrong in it and what it asked the network for.
export async function new_page(browser, options = {}) {
    const context = await browser.newContext({ viewport: { width: 1200, height: 760 }, ...options });
    const page = await context.newPage();
    page.trouble = [];
    page.asked = [];
    page.on('pageerror', (error) => page.trouble.push(`${error.stack}`));
    page.on('console', (message) => { if (message.type() === 'error') page.trouble.push(message.text()); });
    page.on('request', (request) => page.asked.push(request.url()));
    return page;
}

// Opens a file by the page's own button; resolves when it is shown or refused.
export async function open_file(page, path) {
    await page.evaluate(() => { document.title = 'opening'; document.getElementById('broken').hidden = true; });
    await page.setInputFiles('#picker', path);
    await page.waitForFunction(() => document.title !== 'opening' || !document.getElementById('broken').hidden, null, { timeout: 120_000 });
    await settled(page);
}

// Until nothing more is to be drawn.
export async function settled(page) {
    await page.waitForFunction(() => document.getElementById('busy').hidden);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))));
}

export async function set(page, id, share) {
    await page.evaluate(([name, part]) => {
        const input = document.getElementById(name);
        input.value = Math.round(Number(input.min) + part * (Number(input.max) - Number(input.min)));
        input.dispatchEvent(new Event('input'));
    }, [id, share]);
    await settled(page);
}

// The canvas as {width, height, data}, without what lies over it.
export async function picture(page) {
    const hide = await page.addStyleTag({ content: '#legend, #broken { visibility: hidden !important; }' });
    const png = await page.locator('#stage').screenshot();
    await hide.evaluate((node) => node.remove());
    const { width, height, data } = await page.evaluate(async (text) => {
        const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        // Without its rim, which shares pixels with what is around.
        const canvas = new OffscreenCanvas(bitmap.width - 4, bitmap.height - 4), pen = canvas.getContext('2d');
        pen.drawImage(bitmap, -2, -2);
        const { width: w, height: h, data: pixels } = pen.getImageData(0, 0, canvas.width, canvas.height);
        let letters = '';
        for (let i = 0; i < pixels.length; i += 8192) letters += String.fromCharCode(...pixels.subarray(i, i + 8192));
        return { width: w, height: h, data: btoa(letters) };
    }, png.toString('base64'));
    return { width, height, data: new Uint8Array(Buffer.from(data, 'base64')) };
}

// The share of pixels that `is` tells true of.
export function share({ data }, is) {
    let count = 0;
    for (let i = 0; i < data.length; i += 4) count += is(data[i], data[i + 1], data[i + 2]);
    return (4 * count) / data.length;
}
export function difference(a, b) {
    let count = 0;
    for (let i = 0; i < a.data.length; i += 4)
        count += Math.abs(a.data[i] - b.data[i]) + Math.abs(a.data[i + 1] - b.data[i + 1]) + Math.abs(a.data[i + 2] - b.data[i + 2]) > 24;
    return (4 * count) / a.data.length;
}
// How much of the picture is not background, which is the colour near its corner.
export function covered(image) {
    const near = 4 * (8 * image.width + 8), [r, g, b] = image.data.subarray(near, near + 3);
    return share(image, (x, y, z) => Math.abs(x - r) + Math.abs(y - g) + Math.abs(z - b) > 24);
}
export const colourful = (r, g, b) => Math.max(r, g, b) - Math.min(r, g, b) > 40;
