// Camera, light and the canvas. Draws only when something changed.
import { Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

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

        this.controls = new OrbitControls(this.camera, canvas);
        this.still = matchMedia('(prefers-reduced-motion: reduce)');
        const calm = () => { this.controls.enableDamping = !this.still.matches; };
        this.still.addEventListener('change', calm);
        calm();
        this.controls.dampingFactor = 0.12;
        this.controls.zoomToCursor = true;
        this.controls.addEventListener('change', () => this.draw_soon());
        this.half = [1, 1, 1];
        new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
        this.resize();
    }

    resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
        if (width === 0 || height === 0) return;
        this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.draw_soon();
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

    // Puts a box of these half extents into view; flat ones are looked at from their broad side.
    frame(half = this.half) {
        this.half = half;
        const [x, y, z] = half, thin = 0.05;
        const from = FROM.clone();
        if (z < thin * Math.max(x, y)) from.set(0.25, -0.3, 1);
        else if (y < thin * Math.max(x, z)) from.set(0.3, 1, 0.45);
        else if (x < thin * Math.max(y, z)) from.set(1, 0.3, 0.3);
        from.normalize();
        // The corners of the box must lie within both angles of view.
        const tall = Math.tan((this.camera.fov * Math.PI) / 360), wide = tall * this.camera.aspect;
        const right = new Vector3(0, 1, 0).cross(from).normalize(), up = from.clone().cross(right);
        let distance = 0.1;
        for (let i = 0; i < 8; ++i) {
            const corner = new Vector3(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
            const depth = corner.dot(from);
            distance = Math.max(distance, depth + Math.abs(corner.dot(right)) / wide, depth + Math.abs(corner.dot(up)) / tall);
        }
        distance *= 1.06;
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
        offset.applyAxisAngle(new Vector3(0, 1, 0), around);
        const side = new Vector3(0, 1, 0).cross(offset).normalize();
        const tilted = offset.clone().applyAxisAngle(side, over);
        if (Math.abs(tilted.clone().normalize().y) < 0.995) offset.copy(tilted);
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
