// What the view of a run has besides turning and time: fields, deformation, outline, mirrors, cut, arrows, the largest value, the value under
// the pointer, keys.

const AXES = 'xyz';
const HANDLE = 20;  // pixels around the handle of a cut within which it is taken
const ARROW = 0.12;  // of the diagonal: the longest arrow

function addTools(viewer) {
  const tools = viewer.find('.tools'), plain = !viewer.renderer;
  tools.style.display = '';
  addFields(viewer);
  addBar(viewer);
  addDeformation(viewer);
  addMirrors(viewer);
  viewer.walls = new Walls(viewer);
  const cut = new Cut(viewer), list = [cut, viewer.walls];
  if (!plain) list.push(new Mark(viewer), new Arrows(viewer));
  viewer.watchers.push(...list);
  if (!plain) addOutline(viewer);
  for (const name of plain ? ['.outline', '.mark', '.arrows'] : []) viewer.find(name).parentElement.style.display = 'none';
  addPointer(viewer, cut);
  addKeys(viewer, cut);
}

function addFields(viewer) {
  const list = viewer.find('.fields');
  viewer.about.fields.forEach((field, number) => list.add(new Option(nameOf(field), number)));
  list.addEventListener('change', () => {
    viewer.state.field = +list.value;
    viewer.showBar();
    viewer.choose(viewer.state.frame);
  });
}

// The ends of the bar: typed, those of the frame that is shown, or those of the run.
function addBar(viewer) {
  const {surface, state, about} = viewer, [low, high] = ['.bar-low', '.bar-high'].map(name => viewer.find(name)), frame = viewer.find('.bar-frame');
  const set = ends => {
    const field = about.fields[state.field], shadeOf = value => 254 * (value - field.low) / (field.high - field.low);
    field.ends = ends;
    surface.tables[state.field] = ends ? makeColors(field.map, ...ends.map(shadeOf)) : makeColors(field.map);
    viewer.showBar();
    viewer.choose(state.frame);
  };
  const typed = () => {
    const ends = [low, high].map(box => box.valueAsNumber);
    if (ends.every(Number.isFinite) && ends[0] < ends[1]) set(ends);
    else viewer.showBar();
  };
  low.addEventListener('change', typed);
  high.addEventListener('change', typed);
  frame.addEventListener('change', () => set(frame.checked ? findEnds(viewer) : null));
}

// The ends of the field on what is shown in this frame; null where it is the same everywhere.
function findEnds({about, data, surface, state}) {
  const field = about.fields[state.field], shades = data.fields[state.field][state.frame], seen = data.visible && data.visible[state.frame];
  let least = 255, most = -1;
  const take = shade => {
    if (shade === 255) return;
    least = Math.min(least, shade);
    most = Math.max(most, shade);
  };
  for (let f = 0; f < about.faces; ++f) {
    if ((seen && !seen[f]) || state.hidden.has(data.parts[data.owners[f]])) continue;
    if (field.place === 'element') take(shades[data.owners[f]]);
    else for (let k = 4 * f; k < 4 * f + 4; ++k) take(shades[data.corners[k]]);
  }
  return least < most ? [least, most].map(shade => field.low + (field.high - field.low) * shade / 254) : null;
}

function addDeformation(viewer) {
  const swell = viewer.find('.swell');
  swell.addEventListener('input', () => {
    viewer.state.swell = +swell.value;
    viewer.find('.factor').textContent = swell.value;
    viewer.choose(viewer.state.frame);
  });
}

function addOutline(viewer) {
  let start = null;
  const tick = viewer.find('.outline');
  tick.addEventListener('change', () => {
    if (!start) {
      const shape = new THREE.BufferGeometry();
      shape.setAttribute('position', new THREE.BufferAttribute(viewer.surface.makeOutline(), 3));
      start = new THREE.LineSegments(shape, new THREE.LineBasicMaterial({color: 0x1f6fb2}));
      start.frustumCulled = false;
      viewer.scene.add(start);
    }
    start.visible = tick.checked;
    viewer.draw();
  });
}

function addMirrors(viewer) {
  const {about, surface} = viewer, list = viewer.find('.mirror'), symmetry = about.symmetry || [];
  const choices = [['none', []]];
  if (symmetry.length) choices.push([`the deck's symmetry (${symmetry.map(([axis]) => AXES[axis]).join(', ')})`, symmetry]);
  for (let axis = 0; axis < 3; ++axis) {
    choices.push([`at low ${AXES[axis]}`, [[axis, about.low[axis]]]], [`at high ${AXES[axis]}`, [[axis, about.low[axis] + surface.size[axis]]]]);
  }
  choices.forEach(([name], number) => list.add(new Option(name, number)));
  list.addEventListener('change', () => {
    viewer.mirror(choices[+list.value][1]);
    for (const watcher of viewer.watchers) watcher.changed();
    viewer.look(...lastView(viewer));
  });
}

// Azimuth and elevation of the camera.
function lastView(viewer) {
  const [x, y, z] = viewer.camera.position.clone().sub(viewer.controls.target).toArray();
  return [Math.atan2(y, x) * 180 / Math.PI, Math.atan2(z, Math.hypot(x, y)) * 180 / Math.PI];
}

// A plane in space that takes away what is in front of it. Solids show their inside where the page has it.
class Cut {
  constructor(viewer) {
    Object.assign(this, {viewer, list: viewer.find('.cut'), slider: viewer.find('.cut-place'), normal: null, share: 0.5, taken: null});
    const shape = new THREE.BufferGeometry().setFromPoints([[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => new THREE.Vector3(x, y, 0)));
    this.frame = new THREE.LineLoop(shape, new THREE.LineBasicMaterial({color: 0xb45309}));
    this.handle = document.createElement('i');
    this.handle.className = 'handle';
    viewer.canvas.parentElement.append(this.handle);
    this.caps = new THREE.Group();
    this.capMaterial = new THREE.MeshPhongMaterial({vertexColors: THREE.VertexColors || true, side: THREE.DoubleSide, specular: 0x050505, flatShading: true});
    this.lineMaterial = new THREE.LineBasicMaterial({color: 0x4a4f57, transparent: true, opacity: 0.35});
    viewer.scene.add(this.frame, this.caps);
    this.list.addEventListener('change', () => this.choose(this.list.value));
    this.slider.addEventListener('input', () => this.place(+this.slider.value));
    viewer.find('.flip').addEventListener('click', () => { if (this.normal) { this.normal.negate(); this.place(1 - this.share); } });
    this.addDrag();
    this.choose('');
  }

  // '', 'x', 'y', 'z', or 'view': across the direction in which the camera looks. What faces the camera is taken away.
  choose(kind) {
    const {viewer} = this, toCamera = viewer.camera.position.clone().sub(viewer.controls.target).normalize();
    this.list.value = kind;
    this.normal = !kind ? null : kind === 'view' ? toCamera.clone().negate() : new THREE.Vector3().setComponent(AXES.indexOf(kind), 1);
    if (this.normal && kind !== 'view' && this.normal.dot(toCamera) > 0) this.normal.negate();
    for (const part of viewer.box.querySelectorAll('.of-cut')) part.style.display = kind ? '' : 'none';
    viewer.find('.cut-note').textContent = !kind || viewer.painter ? '' : viewer.about.volumes ? 'The section shows what is inside; shells have none.'
      : viewer.about.open ? 'Solids are open: the page does not hold what is inside.' : '';
    this.place(this.share);
  }

  // The least and the largest distance of the scene's corners along the normal, of all that is shown.
  findEnds() {
    const box = new THREE.Box3();
    for (const copy of this.viewer.copies) {
      const half = new THREE.Vector3(...this.viewer.surface.size).multiplyScalar(0.5);
      box.union(new THREE.Box3(half.clone().negate(), half).applyMatrix4(copy.matrixWorld));
    }
    this.center = box.getCenter(new THREE.Vector3());
    const half = box.getSize(new THREE.Vector3()).multiplyScalar(0.5), reach = [0, 1, 2].reduce((sum, i) => sum + Math.abs(this.normal.getComponent(i)) * half.getComponent(i), 0);
    this.half = half.length();
    return [this.normal.dot(this.center) - reach, this.normal.dot(this.center) + reach];
  }

  place(share) {
    this.share = Math.min(1, Math.max(0, share));
    this.slider.value = this.share;
    this.viewer.setPlane(null);
    if (this.normal) {
      const [low, high] = this.findEnds();
      this.viewer.setPlane(new THREE.Plane(this.normal.clone(), -(low + this.share * (high - low))));
    }
    this.changed();
    this.viewer.draw();
  }

  changed() {
    const {viewer} = this, {plane} = viewer;
    this.frame.visible = Boolean(plane) && !viewer.painter;
    for (const child of this.caps.children.splice(0)) child.geometry.dispose();
    if (!plane) return;
    this.spot = plane.projectPoint(this.center, new THREE.Vector3());
    this.frame.position.copy(this.spot);
    this.frame.lookAt(this.spot.clone().add(plane.normal));
    this.frame.scale.setScalar(0.55 * this.half);
    if (viewer.about.volumes && !viewer.painter) for (const copy of viewer.copies) this.addCap(copy.matrixWorld, plane);
  }

  // matrix: a reflection, which is its own inverse; the plane is taken back to the surface.
  addCap(matrix, plane) {
    const {viewer} = this, found = findSection(viewer.surface, viewer.state, plane.clone().applyMatrix4(matrix));
    const shape = new THREE.BufferGeometry(), lines = new THREE.BufferGeometry();
    shape.setAttribute('position', new THREE.BufferAttribute(new Float32Array(found.places), 3));
    shape.setAttribute('color', new THREE.BufferAttribute(new Uint8Array(found.colors), 3, true));
    lines.setAttribute('position', new THREE.BufferAttribute(new Float32Array(found.lines), 3));
    for (const made of [new THREE.Mesh(shape, this.capMaterial), new THREE.LineSegments(lines, this.lineMaterial)]) {
      setMatrix(made, matrix);
      made.found = found;
      if (made.isLineSegments) made.visible = viewer.materials.edges.visible;
      this.caps.add(made);
    }
  }

  drawn() {
    const {viewer} = this;
    this.handle.style.display = viewer.plane ? '' : 'none';
    if (!viewer.plane) return;
    for (const made of this.caps.children) made.visible = !made.isLineSegments || viewer.materials.edges.visible;
    putAt(viewer, this.handle, this.spot);
  }

  addDrag() {
    const {viewer} = this, {canvas} = viewer;
    canvas.addEventListener('pointerdown', event => {
      if (!viewer.plane) return;
      const from = project(viewer, this.spot), frame = canvas.getBoundingClientRect();
      if (Math.hypot(event.clientX - frame.left - from.x, event.clientY - frame.top - from.y) > HANDLE) return;
      const [low, high] = this.findEnds(), to = project(viewer, this.spot.clone().addScaledVector(this.normal, 0.1 * (high - low)));
      const way = new THREE.Vector2(to.x - from.x, to.y - from.y);
      if (way.length() < 4) way.set(0, -0.1 * frame.height);  // it is seen along its normal
      this.taken = {x: event.clientX, y: event.clientY, share: this.share, way};
      viewer.controls.enabled = false;
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', event => {
      if (!this.taken) return;
      const {x, y, share, way} = this.taken;
      this.place(share + 0.1 * ((event.clientX - x) * way.x + (event.clientY - y) * way.y) / way.lengthSq());
    });
    for (const kind of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(kind, () => {
        this.taken = null;
        viewer.controls.enabled = true;
      });
    }
  }
}

function setMatrix(object, matrix) {
  object.matrixAutoUpdate = object.frustumCulled = false;
  object.matrix.copy(matrix);
  object.matrixWorldNeedsUpdate = true;
}

// Pixels from the upper left corner of the canvas.
function project(viewer, point) {
  viewer.camera.updateMatrixWorld();
  const spot = point.clone().project(viewer.camera);
  return {x: (spot.x + 1) / 2 * viewer.canvas.clientWidth, y: (1 - spot.y) / 2 * viewer.canvas.clientHeight, behind: spot.z > 1};
}

function putAt(viewer, mark, point) {
  const {x, y, behind} = project(viewer, point), inside = !behind && x >= 0 && y >= 0 && x <= viewer.canvas.clientWidth && y <= viewer.canvas.clientHeight;
  Object.assign(mark.style, {left: `${viewer.canvas.offsetLeft + x}px`, top: `${viewer.canvas.offsetTop + y}px`, visibility: inside ? 'visible' : 'hidden'});
}

// A ring around the largest value of the frame, over all that hides it.
class Mark {
  constructor(viewer) {
    Object.assign(this, {viewer, tick: viewer.find('.mark'), ring: document.createElement('div')});
    this.ring.className = 'ring';
    viewer.canvas.parentElement.append(this.ring);
    this.tick.addEventListener('change', () => viewer.draw());
  }

  changed() {}

  drawn() {
    const {state, about, surface} = this.viewer, field = about.fields[state.field], largest = (field.largest || [])[state.frame];
    const shown = largest && this.tick.checked && !state.byPart;
    this.ring.style.display = shown ? '' : 'none';
    if (!shown) return;
    this.ring.dataset.text = `max ${largest.value} ${field.unit}`.trim();
    this.ring.title = largest.of;
    putAt(this.viewer, this.ring, surface.show(largest.start, largest.now, state.swell));
  }
}

class Arrows {
  constructor(viewer) {
    Object.assign(this, {viewer, list: viewer.find('.arrows'), size: viewer.find('.arrow-size'), meshes: []});
    viewer.about.arrows.forEach((one, number) => this.list.add(new Option(nameOf(one), number)));
    if (!viewer.about.arrows.length) this.list.parentElement.style.display = 'none';
    this.material = new THREE.MeshLambertMaterial({color: 0x14466e, side: THREE.DoubleSide});
    viewer.materials.arrows = this.material;
    this.list.addEventListener('change', () => { this.changed(); viewer.draw(); });
    this.size.addEventListener('input', () => { this.changed(); viewer.draw(); });
    this.changed();
  }

  changed() {
    const {viewer} = this, number = this.list.value, note = viewer.find('.arrow-note');
    viewer.scene.remove(...this.meshes.splice(0));
    this.size.style.display = number === '' ? 'none' : '';
    note.textContent = '';
    if (number === '') return;
    const about = viewer.about.arrows[+number];
    note.textContent = (about.longest > 0 ? `longest arrow: ${about.longest.toPrecision(3)} ${about.unit}`.trim() : 'all are zero')
      + (about.count < about.of ? `; at ${about.count} of ${about.of} nodes` : '');
    if (this.shape) this.shape.dispose();
    this.shape = new THREE.BufferGeometry();
    this.shape.setAttribute('position', new THREE.BufferAttribute(new Float32Array(this.makeAll(viewer.data.arrows[+number])), 3));
    this.shape.computeVertexNormals();
    for (const copy of viewer.copies) {
      const mesh = new THREE.Mesh(this.shape, this.material);
      setMatrix(mesh, copy.matrixWorld);
      this.meshes.push(mesh);
    }
    viewer.scene.add(...this.meshes);
  }

  drawn() {}

  makeAll({nodes, frames}) {
    const {surface, state} = this.viewer, vectors = frames[state.frame], all = [];
    const factor = ARROW * this.size.value * surface.diagonal / 32767, tail = new THREE.Vector3(), along = new THREE.Vector3();
    for (let i = 0; i < nodes.length; ++i) {
      along.fromArray(vectors, 3 * i).multiplyScalar(factor);
      if (along.length() > 0.002 * surface.diagonal) addArrow(all, tail.fromArray(surface.nodes, 3 * nodes[i]), along);
    }
    return all;
  }
}

// A shaft of three sides and a head of four.
function addArrow(all, tail, along) {
  const length = along.length(), away = Math.abs(along.x) < 0.6 * length ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 1, 0);
  const u = along.clone().cross(away).setLength(length), v = along.clone().cross(u).setLength(length);
  const ring = (count, share, radius) => Array.from({length: count}, (_, k) => tail.clone().addScaledVector(along, share)
    .addScaledVector(u, radius * Math.cos(2 * Math.PI * k / count)).addScaledVector(v, radius * Math.sin(2 * Math.PI * k / count)).toArray());
  const [low, high, head] = [ring(3, 0, 0.02), ring(3, 0.72, 0.02), ring(4, 0.7, 0.08)], tip = tail.clone().add(along).toArray();
  for (let k = 0; k < 3; ++k) {
    const next = (k + 1) % 3;
    all.push(...low[k], ...low[next], ...high[next], ...low[k], ...high[next], ...high[k]);
  }
  for (let k = 0; k < 4; ++k) all.push(...head[k], ...head[(k + 1) % 4], ...tip);
  all.push(...head[0], ...head[2], ...head[1], ...head[0], ...head[3], ...head[2]);
}

// The value under the pointer, or where a finger has tapped.
function addPointer(viewer, cut) {
  const {canvas} = viewer, ray = new THREE.Raycaster(), spot = new THREE.Vector2();
  const show = event => {
    const frame = canvas.getBoundingClientRect();
    spot.set(2 * (event.clientX - frame.left) / frame.width - 1, 1 - 2 * (event.clientY - frame.top) / frame.height);
    ray.setFromCamera(spot, viewer.camera);
    viewer.find('.value').textContent = tellAt(viewer, cut, ray);
  };
  let pressed = null;
  canvas.addEventListener('pointermove', event => { if (!event.buttons && !cut.taken) show(event); });
  canvas.addEventListener('pointerdown', event => { pressed = event; });
  canvas.addEventListener('pointerup', event => {
    if (pressed && Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY) < 5) show(event);
    pressed = null;
  });
}

function tellAt(viewer, cut, ray) {
  const meshes = viewer.copies.map(copy => copy.children[0]);
  const hit = ray.intersectObjects(meshes).find(one => !viewer.plane || viewer.plane.distanceToPoint(one.point) >= 0);
  const inside = viewer.plane && viewer.about.volumes && ray.intersectObjects(cut.caps.children.filter(one => one.isMesh))[0];
  const {object, point, faceIndex} = (inside && (!hit || inside.distance < hit.distance) ? inside : hit) || {};
  if (!object) return '';
  const at = object.worldToLocal(point.clone());
  return object.found ? tellInside(viewer, object.found, faceIndex, at) : tell(viewer, viewer.surface.shown[Math.floor(faceIndex / 2)], at);
}

// The text of a section: the value of its element, or at the nearest corner of a triangle.
function tellInside({about, data, state}, found, triangle, at) {
  const element = found.elements[triangle], name = about.parts[data.parts[element]];
  const far = [0, 1, 2].map(k => at.distanceTo(new THREE.Vector3().fromArray(found.places, 9 * triangle + 3 * k)));
  const shade = found.shades[3 * triangle + far.indexOf(Math.min(...far))];
  return state.byPart ? name : `${name}, element ${data.elementIds[element]}: ${tellValue(about.fields[state.field], shade)}`;
}

// Part, element or nearest node, and value of a face, to one 254th of the bar.
function tell(viewer, face, at) {
  const {about, data, surface, state} = viewer, field = about.fields[state.field], owner = data.owners[face], name = about.parts[data.parts[owner]];
  if (state.byPart) return name;
  let item = owner, words = `element ${data.elementIds[owner]}`;
  if (field.place !== 'element') {
    const nodes = [...data.corners.subarray(4 * face, 4 * face + 4)], far = nodes.map(node => surface.placeOf(node).distanceTo(at));
    item = nodes[far.indexOf(Math.min(...far))];
    words = `node ${data.nodeIds[item]}`;
  }
  return `${name}, ${words}: ${tellValue(field, data.fields[state.field][state.frame][item])}`;
}

function tellValue(field, shade) {
  if (shade === 255) return 'no number';
  const beyond = field.note && (shade === 254 ? 'at least ' : shade === 0 ? 'at most ' : '') || '';
  return `${beyond}${+(field.low + (field.high - field.low) * shade / 254).toPrecision(3)} ${field.unit}`.trim();
}

const KEYS = [['\u2190 \u2192', 'frame'], ['Home End', 'first, last frame'], ['space', 'play'], ['f', 'next field'], ['r', 'bar of this frame, or of the run'], ['x y z d', 'look along an axis, default view'],
  ['+ \u2212', 'zoom'], ['c', 'cut: x, y, z, across the view, none'], ['[ ]', 'move the cut'], ['i', 'turn the cut around'], ['e', 'edges'], ['p', 'colours by part'],
  ['o', 'outline of the start'], ['m', 'mirror'], ['w', 'rigid walls'], ['a', 'arrows'], ['l', 'largest value'], ['h', 'this list']];

function addKeys(viewer, cut) {
  const next = name => {
    const list = viewer.find(name);
    list.selectedIndex = (list.selectedIndex + 1) % list.options.length;
    list.dispatchEvent(new Event('change'));
  };
  const list = viewer.find('.keys'), zoom = factor => {
    viewer.camera.position.sub(viewer.controls.target).multiplyScalar(factor).add(viewer.controls.target);
    viewer.controls.update();
    viewer.draw();
  };
  const {frames} = viewer.about, go = frame => viewer.choose((frame + frames) % frames), look = number => viewer.box.querySelectorAll('[data-view]')[number].click();
  const actions = {ArrowRight: () => go(viewer.state.frame + 1), ArrowLeft: () => go(viewer.state.frame - 1), Home: () => go(0), End: () => go(frames - 1),
    ' ': () => viewer.play(), f: () => next('.fields'), r: () => viewer.find('.bar-frame').click(), d: () => look(0), x: () => look(1), y: () => look(2), z: () => look(3),
    '+': () => zoom(1 / 1.15), '=': () => zoom(1 / 1.15), '-': () => zoom(1.15), c: () => next('.cut'), '[': () => cut.place(cut.share - 0.02),
    ']': () => cut.place(cut.share + 0.02), i: () => viewer.find('.flip').click(), e: () => viewer.find('.edges').click(),
    p: () => viewer.find('.by-part').click(), o: () => viewer.find('.outline').click(), m: () => next('.mirror'), w: () => viewer.find('.walls').click(), a: () => next('.arrows'),
    l: () => viewer.find('.mark').click(), h: () => { list.hidden = !list.hidden; }};
  list.replaceChildren(...KEYS.map(([key, words]) => {
    const row = document.createElement('span'), shown = document.createElement('b');
    shown.textContent = key;
    row.append(shown, ` ${words}`);
    return row;
  }));
  window.addEventListener('keydown', event => {
    const {target} = event, writes = target.tagName === 'SELECT' || (target.tagName === 'INPUT' && target.type !== 'checkbox');
    const own = target.tagName !== 'CANVAS' && event.key === ' ' && /^(BUTTON|INPUT|SUMMARY)$/.test(target.tagName);
    if (writes || own || event.ctrlKey || event.metaKey || event.altKey || !actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  });
}
