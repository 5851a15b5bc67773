// The interactive view of a run: its surface, turned with the mouse, over time. Starts when the page has been read.

const AMBIENT = 0.42, LIGHTS = [[-0.5, 0.95, 0.75, 0.42], [0.9, 0.15, 0.75, 0.26]];  // where they are as the camera sees it, and their strength

const FAR_BITS = 1.4;  // of the distance from which nearly all is in view: what needs more is left out

const MANY_FACES = 30000;  // above it edges are a choice, and lines are not smoothed: that takes most of the time of software that draws

class Viewer {
  constructor(about, data, box) {
    Object.assign(this, {about, data, box, canvas: box.querySelector('canvas'), surface: new Surface(about, data)});
    this.state = {frame: about.frames - 1, byPart: Boolean(about.byPart), hidden: new Set(), field: 0, swell: 1};
    this.plane = null;  // of a cut
    this.watchers = [];  // called after a frame has changed, and before each picture
    this.camera = new THREE.PerspectiveCamera(24, 1, this.surface.diagonal / 1000, this.surface.diagonal * 50);
    this.camera.up.set(0, 0, 1);
    try {
      this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: about.faces <= MANY_FACES, preserveDrawingBuffer: true});
    } catch (error) {
      const plain = this.canvas.cloneNode();  // the other may have a kind already
      this.canvas.replaceWith(plain);
      this.canvas = plain;
      this.painter = new Painter(plain, this.surface);
    }
    this.makeScene();
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enableKeys = false;
    this.controls.addEventListener('change', () => this.draw());
    this.makeSwitches();
  }

  find(name) { return this.box.querySelector(name); }

  makeScene() {
    const {surface} = this;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color('#ffffff');
    this.scene.add(new THREE.AmbientLight(0xffffff, AMBIENT), this.camera);
    for (const [x, y, z, strength] of LIGHTS) {
      const light = new THREE.DirectionalLight(0xffffff, strength);
      light.position.set(x, y, z);
      this.camera.add(light, light.target);  // a target that stays in the middle of the scene would have light come from the camera
    }
    this.materials = {
      surface: new THREE.MeshPhongMaterial({vertexColors: THREE.VertexColors || true, side: THREE.DoubleSide, specular: 0x050505,
        polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, flatShading: true}),
      edges: new THREE.LineBasicMaterial({color: 0x4a4f57, transparent: true, opacity: 0.35}),
      beams: new THREE.LineBasicMaterial({vertexColors: THREE.VertexColors || true, linewidth: 3}),
    };
    this.copies = [];
    this.mirror([]);
    this.setEdges(this.about.faces <= MANY_FACES);
  }

  // planes: [axis, value] of mirrors, in places of the run. The surface and its images; two mirrors give three.
  mirror(planes) {
    for (const copy of this.copies) this.scene.remove(copy);
    const {surface, materials} = this;
    this.copies = [];
    for (let chosen = 0; chosen < 1 << planes.length; ++chosen) {
      const copy = new THREE.Group(), lines = new THREE.LineSegments(surface.edges, materials.edges);
      planes.forEach(([axis, value], number) => {
        if (!(chosen >> number & 1)) return;
        copy.scale.setComponent(axis, -1);
        copy.position.setComponent(axis, 2 * (value - surface.middle[axis]));
      });
      copy.add(new THREE.Mesh(surface.triangles, materials.surface), lines, new THREE.LineSegments(surface.beams, materials.beams));
      copy.children.forEach(child => { child.frustumCulled = false; });
      copy.updateMatrixWorld();
      this.copies.push(copy);
      this.scene.add(copy);
    }
  }

  setEdges(shown) {
    this.materials.edges.visible = this.find('.edges').checked = shown;
    this.draw();
  }

  setPlane(plane) {
    this.plane = plane;
    if (this.renderer) this.renderer.localClippingEnabled = Boolean(plane);
    for (const material of Object.values(this.materials)) material.clippingPlanes = plane ? [plane] : [];
  }

  choose(frame) {
    this.state.frame = frame;
    this.slider.value = frame;
    this.surface.fill(this.state);
    this.find('.clock').textContent = `${this.about.times[frame]} (frame ${this.about.numbers[frame]})`;
    for (const watcher of this.watchers) watcher.changed();
    this.draw();
  }

  draw() {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    this.due = false;
    for (const watcher of this.watchers) watcher.drawn();
    if (this.renderer) this.renderer.render(this.scene, this.camera);
    else this.painter.paint(this.camera, {edges: this.materials.edges.visible, copies: this.copies.map(copy => copy.matrixWorld), plane: this.plane,
      walls: this.walls ? this.walls.list() : []});
  }

  // Some nodes of the frame, and the middle of their box, but for one in two hundred at each side: few bits that fly far do
  // not count.
  sampleNodes() {
    const sample = [], step = Math.ceil(this.about.nodes / 5000);
    for (const copy of this.copies) {
      for (let n = 0; n < this.about.nodes; n += step) sample.push(this.surface.placeOf(n).applyMatrix4(copy.matrixWorld).toArray());
    }
    const center = [0, 1, 2].map(i => {
      const along = sample.map(p => p[i]).sort((a, b) => a - b), last = along.length - 1;
      return (along[Math.floor(0.005 * last)] + along[Math.ceil(0.995 * last)]) / 2;
    });
    return {sample, center};
  }

  // From where they are in view, but for bits that are far from the rest.
  findDistance({sample, center}, back, right, up) {
    const tangent = Math.tan(this.camera.fov * Math.PI / 360);
    const needed = sample.map(point => {
      const along = axis => point.reduce((sum, x, i) => sum + (x - center[i]) * axis[i], 0);
      return along(back) + 1.16 * Math.max(Math.abs(along(right)) / (tangent * this.camera.aspect), Math.abs(along(up)) / tangent);
    }).sort((a, b) => a - b);
    const most = needed[needed.length - 1], usual = needed[Math.floor(0.995 * (needed.length - 1))];
    return Math.max(Math.min(most, FAR_BITS * usual), 0.1 * this.surface.diagonal);
  }

  look(azimuth, elevation) {
    const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
    const back = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    const seen = this.sampleNodes();
    const far = this.findDistance(seen, back, [-Math.sin(a), Math.cos(a), 0],
      [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)]);
    this.controls.target.set(...seen.center);
    this.camera.position.set(...back.map((x, i) => seen.center[i] + far * x));
    this.controls.update();
    this.draw();
  }

  resize() {
    const width = this.canvas.parentElement.clientWidth, height = Math.round(Math.min(width * 0.5625, window.innerHeight * 0.8));
    if (this.renderer) {
      this.renderer.setPixelRatio(window.devicePixelRatio || 1);
      this.renderer.setSize(width, height, false);
    } else this.painter.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  play() {
    const button = this.find('.play');
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = null;
      button.textContent = 'Play';
      return;
    }
    button.textContent = 'Stop';
    this.timer = setInterval(() => this.choose((this.state.frame + 1) % this.about.frames), Math.max(1000 / 30, 2500 / this.about.frames));
  }

  makeSwitches() {
    this.slider = this.find('input[type=range]');
    this.slider.max = this.about.frames - 1;
    this.slider.addEventListener('input', () => this.choose(+this.slider.value));
    this.find('.play').addEventListener('click', () => this.play());
    this.find('.by-part').checked = this.state.byPart;
    this.find('.by-part').addEventListener('change', event => { this.state.byPart = event.target.checked; this.choose(this.state.frame); });
    this.find('.edges').addEventListener('change', event => this.setEdges(event.target.checked));
    for (const button of this.box.querySelectorAll('[data-view]')) {
      button.addEventListener('click', () => this.look(...button.dataset.view.split(':').map(Number)));
    }
    this.about.parts.slice(0, 24).forEach((name, number) => this.addSwitch(this.find('.parts'), name, this.about.partColors[number], true, shown => {
      if (shown) this.state.hidden.delete(number); else this.state.hidden.add(number);
      this.choose(this.state.frame);
    }));
    if (this.about.still) this.find('.time').style.display = 'none';
    this.showBar();
  }

  addSwitch(row, name, color, on, change) {
    const label = document.createElement('label'), tick = document.createElement('input'), patch = document.createElement('i');
    tick.type = 'checkbox';
    tick.checked = on;
    patch.style.background = color;
    tick.addEventListener('change', () => change(tick.checked));
    label.append(tick, patch, name);
    row.append(label);
  }

  showBar() {
    const field = this.about.fields[this.state.field], {ends} = field;
    const labels = ends ? [0, 1, 2, 3, 4].map(k => String(+(ends[0] + k / 4 * (ends[1] - ends[0])).toPrecision(4))) : field.labels;
    this.find('.bar-title').textContent = nameOf(field) + (field.note ? ` (${field.note})` : '');
    this.find('.bar i').style.background = `linear-gradient(to right, ${field.map.join(',')})`;
    this.find('.bar-labels').replaceChildren(...labels.map(text => {
      const label = document.createElement('span');
      label.textContent = text;
      return label;
    }));
    const [low, high] = ends || [field.low, field.high];
    this.find('.bar-low').value = +low.toPrecision(4);
    this.find('.bar-high').value = +high.toPrecision(4);
    this.find('.bar-frame').checked = Boolean(ends);
  }

  // Marks beside the surface, of a scene before its run: sets, conditions, walls, arrows, overlaps (preview/marks.py).
  addLayer(layer) {
    let corners = layer.places.map((x, i) => x - this.surface.middle[i % 3]);
    if (layer.kind === 'arrows') corners = addHeads(corners);
    if (layer.kind === 'plates') corners = addTriangles(corners);
    const shape = new THREE.BufferGeometry();
    shape.setAttribute('position', new THREE.BufferAttribute(new Float32Array(corners), 3));
    const look = {color: layer.color, depthTest: !layer.top, transparent: true};
    let made;
    if (layer.kind === 'points') made = new THREE.Points(shape, new THREE.PointsMaterial({...look, size: layer.top ? 8 : 5, sizeAttenuation: false}));
    else if (layer.kind === 'plates') made = new THREE.Mesh(shape, new THREE.MeshBasicMaterial({...look, opacity: 0.25, depthWrite: false, side: THREE.DoubleSide}));
    else made = new THREE.LineSegments(shape, new THREE.LineBasicMaterial({...look, linewidth: 2}));
    made.frustumCulled = false;
    made.visible = layer.shown;
    made.renderOrder = layer.top ? 2 : 1;
    this.scene.add(made);
    this.addSwitch(this.find('.layers'), layer.name, layer.color, layer.shown, shown => { made.visible = shown; this.draw(); });
  }
}

const nameOf = field => field.title + (field.unit ? ` [${field.unit}]` : '');

function addHeads(lines) {
  const all = lines.slice();
  for (let i = 0; i < lines.length; i += 6) {
    const tail = new THREE.Vector3(...lines.slice(i, i + 3)), tip = new THREE.Vector3(...lines.slice(i + 3, i + 6));
    const along = tip.clone().sub(tail), length = along.length();
    const away = Math.abs(along.x) < 0.6 * length ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 1, 0);
    const first = along.clone().cross(away).setLength(0.11 * length), second = along.clone().cross(first).setLength(0.11 * length);
    for (const side of [first, second]) {
      for (const sign of [1, -1]) all.push(...tip.toArray(), ...tip.clone().addScaledVector(along, -0.3).addScaledVector(side, sign).toArray());
    }
  }
  return all;
}

function addTriangles(plates) {
  const all = [];
  for (let i = 0; i < plates.length; i += 12) {
    for (const t of [0, 1, 2, 0, 2, 3]) all.push(...plates.slice(i + 3 * t, i + 3 * t + 3));
  }
  return all;
}

async function start() {
  const about = JSON.parse(document.getElementById('surface-about').textContent), box = document.getElementById('view'), note = box.querySelector('.note');
  let data;
  try {
    data = readPack(about, await unpack(document.getElementById('surface-data').textContent.trim()));
  } catch (error) {
    note.textContent = `This browser cannot unpack the surface: ${error}`;
    return;
  }
  const viewer = new Viewer(about, data, box);
  box.viewer = viewer;
  for (const layer of about.layers || []) viewer.addLayer(layer);
  if (!about.still) addTools(viewer);
  viewer.choose(viewer.state.frame);
  viewer.resize();
  viewer.look(-50, 22);
  window.addEventListener('resize', () => viewer.resize());
  note.textContent = viewer.renderer ? 'Drag turns, wheel or pinch zooms, right button or two fingers move.' + (about.still ? '' : ' Keys: h lists them.')
    : 'This browser has no WebGL: the view consists of plain pictures, in which near faces may overlap wrongly; there are no outline, arrows, sections or marks, and a cut leaves out whole faces.';
  viewer.drawNow();
  box.dataset.ready = 'yes';
}

start();
