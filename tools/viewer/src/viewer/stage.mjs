// Camera, light and the canvas. Draws only when something changed.
import { Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

// A sample is enough to see how large a mesh looks.
const MOST_FRAMED = 20_000;
const FROM = new Vector3(0.62, 0.5, 0.85).normalize();

export class Stage {
    constructor(canvas) {
        this.canvas = canvas;
        this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
        this.renderer.localClippingEnabled = true;
        this.scene = new Scene();
        this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
        this.before_draw = [];
        // The lights go with the camera: whatever is looked at is lit from over the left shoulder.
        this.sky = new HemisphereLight(0xffffff, 0x9a948a, 1.7);
        this.key = new DirectionalLight(0xffffff, 2.1);
        this.fill = new DirectionalLight(0xffffff, 0.5);
        this.key.position.set(-1.2, 1.6, 2.2);
        this.fill.position.set(2, -0.4, 0.6);
        this.camera.add(this.key, this.fill, this.key.target, this.fill.target);
        this.key.target.position.z = this.fill.target.position.z = -1;
        this.scene.add(this.camera, this.sky);

        this.still = matchMedia('(prefers-reduced-motion: reduce)');
        this.still.addEventListener('change', () => { this.controls.enableDamping = !this.still.matches; });
        this.set_up(1);
        this.half = [1, 1, 1];
        this.points = new Float32Array(0);
        this.inset = 0;
        new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
        this.resize();
    }

    resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
        if (width === 0 || height === 0) return;
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.set_inset(this.inset);
    }

    // Pixels at the bottom that something lies over: the middle moves up by half of them.
    set_inset(inset) {
        const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
        this.inset = inset;
        this.camera.setViewOffset(width, height, 0, inset / 2, width, height);
        this.draw_soon();
    }

    // Which axis points up: 1 for Y, 2 for Z. Controls take it once, when they are made.
    set_up(axis) {
        this.controls?.dispose();
        this.camera.up.set(0, axis === 1 ? 1 : 0, axis === 1 ? 0 : 1);
        this.controls = new OrbitControls(this.camera, this.canvas);
        this.controls.enableDamping = !this.still.matches;
        this.controls.dampingFactor = 0.12;
        this.controls.zoomToCursor = true;
        this.controls.addEventListener('change', () => this.draw_soon());
    }

    set_background(css) {
        this.scene.background = new Color(css);
        this.draw_soon();
    }

    draw_soon() {
        this.pending ??= requestAnimationFrame(() => this.draw());
    }
    draw() {
        this.pending = undefined;
        if (this.controls.enableDamping) this.controls.update();
        for (const work of this.before_draw) work(this);
        this.renderer.render(this.scene, this.camera);
    }

    // Device pixels that one drawn unit takes at the orbit's centre.
    pixels_per_unit() {
        const distance = this.camera.position.distanceTo(this.controls.target);
        return this.renderer.domElement.height / (2 * distance * Math.tan((this.camera.fov * Math.PI) / 360));
    }

    // Puts a mesh into view, of which half the extents and some points are known; flat ones are looked at
    // from their broad side.
    frame(half = this.half, points = this.points) {
        this.half = half;
        this.points = points;
        const z_up = this.camera.up.z > 0, [x, y, z] = z_up ? [half[0], half[2], half[1]] : half, thin = 0.05;
        const from = FROM.clone();
        if (z < thin * Math.max(x, y)) from.set(0.25, -0.3, 1);
        else if (y < thin * Math.max(x, z)) from.set(0.3, 1, 0.45);
        else if (x < thin * Math.max(y, z)) from.set(1, 0.3, 0.3);
        if (z_up) from.set(from.x, -from.z, from.y);
        from.normalize();
        // All points must lie within both angles of view.
        const all = Math.tan((this.camera.fov * Math.PI) / 360), wide = all * this.camera.aspect;
        const tall = all * (1 - this.inset / this.canvas.parentElement.clientHeight);
        const right = this.camera.up.clone().cross(from).normalize(), up = from.clone().cross(right), point = new Vector3();
        let distance = 0.1;
        const step = 3 * Math.max(1, Math.floor(points.length / 3 / MOST_FRAMED));
        for (let i = 0; i + 2 < points.length; i += step) {
            point.fromArray(points, i);
            const depth = point.dot(from);
            distance = Math.max(distance, depth + Math.abs(point.dot(right)) / wide, depth + Math.abs(point.dot(up)) / tall);
        }
        distance *= 1.1;
        this.controls.target.set(0, 0, 0);
        this.camera.position.copy(from).multiplyScalar(distance);
        const radius = Math.hypot(x, y, z) || 1;
        this.camera.near = radius / 500;
        this.camera.far = radius * 60;
        this.controls.minDistance = radius / 200;
        this.controls.maxDistance = radius * 25;
        this.camera.updateProjectionMatrix();
        this.controls.update();
        this.draw_soon();
    }

    orbit(around, over) {
        const offset = this.camera.position.clone().sub(this.controls.target);
        offset.applyAxisAngle(this.camera.up, around);
        const side = this.camera.up.clone().cross(offset).normalize();
        const tilted = offset.clone().applyAxisAngle(side, over);
        if (Math.abs(tilted.clone().normalize().dot(this.camera.up)) < 0.995) offset.copy(tilted);
        this.camera.position.copy(this.controls.target).add(offset);
        this.controls.update();
        this.draw_soon();
    }
    zoom(factor) {
        const offset = this.camera.position.clone().sub(this.controls.target);
        this.camera.position.copy(this.controls.target).add(offset.multiplyScalar(factor));
        this.controls.update();
        this.draw_soon();
    }
}
