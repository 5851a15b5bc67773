// The interactive view of a report: the surface of a run, turned with the mouse, over time. Data: reporting/surface.py.
(async function () {
  'use strict';
  const about = JSON.parse(document.getElementById('surface-about').textContent);
  const box = document.getElementById('view');
  const show = text => { box.querySelector('.note').textContent = text; };

  async function unpack(text) {
    const packed = Uint8Array.from(atob(text), c => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  // Pieces of the pack in their order.
  function read(bytes) {
    let at = 0;
    const take = count => bytes.slice(at, at += count);
    const data = {corners: new Uint32Array(take(16 * about.faces).buffer), parts: take(about.faces)};
    const numbers = 3 * about.nodes;
    data.places = [];
    for (let f = 0; f < about.frames; ++f) {
      const low = take(numbers), high = take(numbers), now = new Uint16Array(numbers);
      for (let i = 0; i < numbers; ++i) now[i] = low[i] + 256 * high[i] + (f ? data.places[f - 1][i] : 0);
      data.places.push(now);
    }
    data.fields = about.fields.map(field =>
      Array.from({length: about.frames}, () => take(field.place === 'element' ? about.faces : about.nodes)));
    data.visible = about.erodes ? Array.from({length: about.frames}, () => take(about.faces)) : null;
    return data;
  }

  const rgb = text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255);
  function makeColors(map) {
    const stops = map.map(rgb), table = [];
    for (let i = 0; i < 255; ++i) {
      const x = i / 254 * (stops.length - 1), k = Math.min(Math.floor(x), stops.length - 2);
      table.push(stops[k].map((c, j) => c + (x - k) * (stops[k + 1][j] - c)));
    }
    table.push([1, 0, 1]);  // no number
    return table;
  }

  let data;
  try {
    data = read(await unpack(document.getElementById('surface-data').textContent.trim()));
  } catch (error) {
    show('This browser cannot unpack the surface: ' + error);
    return;
  }
  const canvas = box.querySelector('canvas');
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
  } catch (error) {
    show('This browser has no WebGL: the pictures above show the same surface.');
    return;
  }

  const table = makeColors(about.map), partColors = about.partColors.map(rgb);
  const size = about.scale.map(s => s * 65535), diagonal = Math.hypot(...size);
  const middle = about.low.map((l, i) => l + size[i] / 2);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color('#ffffff');
  const camera = new THREE.PerspectiveCamera(24, 1, diagonal / 1000, diagonal * 50);
  camera.up.set(0, 0, 1);
  scene.add(new THREE.AmbientLight(0xffffff, 0.42), camera);
  for (const [x, y, z, strength] of [[-0.5, 0.95, 0.75, 0.42], [0.9, 0.15, 0.75, 0.26]]) {
    const light = new THREE.DirectionalLight(0xffffff, strength);
    light.position.set(x, y, z);
    camera.add(light);
  }
  const places = new Float32Array(18 * about.faces), shades = new Float32Array(18 * about.faces);
  const surface = new THREE.BufferGeometry();
  surface.setAttribute('position', new THREE.BufferAttribute(places, 3));
  surface.setAttribute('color', new THREE.BufferAttribute(shades, 3));
  const material = new THREE.MeshPhongMaterial({vertexColors: THREE.VertexColors || true, side: THREE.DoubleSide, specular: 0x050505,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, flatShading: true});
  const mesh = new THREE.Mesh(surface, material);
  mesh.frustumCulled = false;
  const edgePlaces = new Float32Array(24 * about.faces);
  const edges = new THREE.BufferGeometry();
  edges.setAttribute('position', new THREE.BufferAttribute(edgePlaces, 3));
  const lines = new THREE.LineSegments(edges, new THREE.LineBasicMaterial({color: 0x4a4f57, transparent: true, opacity: 0.35}));
  lines.frustumCulled = false;
  scene.add(mesh, lines);

  const state = {frame: about.frames - 1, byPart: Boolean(about.byPart), hidden: new Set(), field: 0, swell: 1, shown: []};
  const triangles = [0, 1, 2, 0, 2, 3], sides = [0, 1, 1, 2, 2, 3, 3, 0];

  function fill() {
    const field = about.fields[state.field], start = data.places[0];
    const now = data.places[state.frame], shade = data.fields[state.field][state.frame], seen = data.visible && data.visible[state.frame];
    let corner = 0, end = 0;
    const put = (array, at, node) => {
      for (let i = 0; i < 3; ++i) {
        const k = 3 * node + i;
        array[3 * at + i] = about.low[i] - middle[i] + about.scale[i] * (start[k] + state.swell * (now[k] - start[k]));
      }
    };
    state.shown = [];
    for (let f = 0; f < about.faces; ++f) {
      if ((seen && !seen[f]) || state.hidden.has(data.parts[f])) continue;
      state.shown.push(f);
      for (const t of triangles) {
        const node = data.corners[4 * f + t];
        put(places, corner, node);
        const color = state.byPart ? partColors[data.parts[f]] : table[shade[field.place === 'element' ? f : node]];
        shades.set(color, 3 * corner++);
      }
      for (const s of sides) put(edgePlaces, end++, data.corners[4 * f + s]);
    }
    surface.setDrawRange(0, corner);
    edges.setDrawRange(0, end);
    surface.attributes.position.needsUpdate = surface.attributes.color.needsUpdate = edges.attributes.position.needsUpdate = true;
    box.querySelector('.clock').textContent = about.times[state.frame] + ' (frame ' + about.numbers[state.frame] + ')';
  }

  // Marks beside the surface, of a scene before its run: sets, conditions, walls, arrows, overlaps (reporting/marks.py).
  function addLayer(layer) {
    let corners = [];
    for (let i = 0; i < layer.places.length; ++i) corners.push(layer.places[i] - middle[i % 3]);
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
    scene.add(made);
    addSwitch(box.querySelector('.layers'), layer.name, layer.color, layer.shown, shown => { made.visible = shown; draw(); });
  }
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
  function addSwitch(row, name, color, on, change) {
    const label = document.createElement('label'), tick = document.createElement('input'), patch = document.createElement('i');
    tick.type = 'checkbox';
    tick.checked = on;
    patch.style.background = color;
    tick.addEventListener('change', () => change(tick.checked));
    label.append(tick, patch, name);
    row.append(label);
  }

  let due = false;
  function draw() {
    if (due) return;
    due = true;
    requestAnimationFrame(() => { due = false; renderer.render(scene, camera); });
  }
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.addEventListener('change', draw);

  // Some nodes of the frame, and the middle of their box, but for one in two hundred at each side: few bits that fly far do
  // not count.
  function sampleNodes() {
    const now = data.places[state.frame], sample = [];
    for (let n = 0; n < about.nodes; n += Math.ceil(about.nodes / 5000))
      sample.push([0, 1, 2].map(i => about.low[i] - middle[i] + about.scale[i] * now[3 * n + i]));
    const center = [0, 1, 2].map(i => {
      const along = sample.map(p => p[i]).sort((a, b) => a - b), last = along.length - 1;
      return (along[Math.floor(0.005 * last)] + along[Math.ceil(0.995 * last)]) / 2;
    });
    return {sample, center};
  }

  // From where they are in view.
  function findDistance({sample, center}, back, right, up) {
    const tangent = Math.tan(camera.fov * Math.PI / 360);
    const needed = sample.map(point => {
      const along = axis => point.reduce((sum, x, i) => sum + (x - center[i]) * axis[i], 0);
      return along(back) + 1.16 * Math.max(Math.abs(along(right)) / (tangent * camera.aspect), Math.abs(along(up)) / tangent);
    }).sort((a, b) => a - b);
    return Math.max(needed[Math.floor(0.995 * (needed.length - 1))], 0.1 * diagonal);
  }

  function look(azimuth, elevation) {
    const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
    const back = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    const seen = sampleNodes();
    const far = findDistance(seen, back, [-Math.sin(a), Math.cos(a), 0],
      [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)]);
    controls.target.set(...seen.center);
    camera.position.set(...back.map((x, i) => seen.center[i] + far * x));
    controls.update();
    draw();
  }
  function resize() {
    const width = canvas.parentElement.clientWidth, height = Math.round(Math.min(width * 0.5625, window.innerHeight * 0.8));
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    draw();
  }
  const slider = box.querySelector('input[type=range]');
  slider.max = about.frames - 1;
  slider.value = state.frame;
  const choose = frame => { state.frame = frame; slider.value = frame; fill(); draw(); };
  slider.addEventListener('input', () => choose(+slider.value));
  let timer = null;
  const play = box.querySelector('.play');
  play.addEventListener('click', () => {
    if (timer) { clearInterval(timer); timer = null; play.textContent = 'Play'; return; }
    play.textContent = 'Stop';
    timer = setInterval(() => choose((state.frame + 1) % about.frames), 120);
  });
  box.querySelector('.by-part').addEventListener('change', event => { state.byPart = event.target.checked; choose(state.frame); });
  box.querySelector('.edges').addEventListener('change', event => { lines.visible = event.target.checked; draw(); });
  for (const button of box.querySelectorAll('[data-view]')) {
    button.addEventListener('click', () => look(...button.dataset.view.split(':').map(Number)));
  }
  about.parts.slice(0, 24).forEach((name, number) => addSwitch(box.querySelector('.parts'), name, about.partColors[number], true, shown => {
    if (shown) state.hidden.delete(number); else state.hidden.add(number);
    choose(state.frame);
  }));
  for (const layer of about.layers || []) addLayer(layer);
  box.querySelector('.by-part').checked = state.byPart;
  if (about.still) box.querySelector('.time').style.display = 'none';
  lines.visible = box.querySelector('.edges').checked = about.faces <= 30000;
  function showBar() {
    const field = about.fields[state.field];
    box.querySelector('.bar-title').textContent = field.label;
    box.querySelector('.bar i').style.background = `linear-gradient(to right, ${field.map.join(',')})`;
    box.querySelector('.bar-labels').replaceChildren(...field.labels.map(text => {
      const label = document.createElement('span');
      label.textContent = text;
      return label;
    }));
  }
  showBar();
  if (about.tools) addTools();
  // What `percuss view` has besides: fields, deformation, outline, mirrors, the value under the pointer, keys.
  function addTools() {
    const row = box.querySelector('.tools'), find = name => row.querySelector(name);
    row.style.display = '';
    about.fields.forEach((field, number) => find('.fields').add(new Option(field.label, number)));
    find('.fields').addEventListener('change', event => { state.field = +event.target.value; showBar(); choose(state.frame); });
    find('.swell').addEventListener('input', event => {
      state.swell = +event.target.value;
      find('.factor').textContent = state.swell;
      choose(state.frame);
    });
    const outline = new THREE.BufferGeometry(), ends = new Float32Array(24 * about.faces);
    for (let f = 0, at = 0; f < about.faces; ++f) {
      for (const s of sides) {
        for (let i = 0; i < 3; ++i) ends[at++] = about.low[i] - middle[i] + about.scale[i] * data.places[0][3 * data.corners[4 * f + s] + i];
      }
    }
    outline.setAttribute('position', new THREE.BufferAttribute(ends, 3));
    const start = new THREE.LineSegments(outline, new THREE.LineBasicMaterial({color: 0x1f6fb2, transparent: true, opacity: 0.25}));
    start.visible = false;
    start.frustumCulled = false;
    scene.add(start);
    find('.outline').addEventListener('change', event => { start.visible = event.target.checked; draw(); });
    const copies = [];
    find('.mirror').addEventListener('change', event => {
      scene.remove(...copies.splice(0));
      const [axis, side] = event.target.value ? [+event.target.value[0], event.target.value[1] === '-' ? -1 : 1] : [-1, 0];
      for (const one of axis < 0 ? [] : [mesh, lines]) {
        const copy = one.clone();
        copy.scale.setComponent(axis, -1);
        copy.position.setComponent(axis, side * size[axis]);
        copies.push(copy);
      }
      if (copies.length) scene.add(...copies);
      draw();
    });
    const ray = new THREE.Raycaster(), spot = new THREE.Vector2();
    canvas.addEventListener('pointermove', event => {
      if (event.buttons) return;
      const frame = canvas.getBoundingClientRect();
      spot.set(2 * (event.clientX - frame.left) / frame.width - 1, 1 - 2 * (event.clientY - frame.top) / frame.height);
      surface.computeBoundingSphere();
      ray.setFromCamera(spot, camera);
      const hit = ray.intersectObject(mesh)[0];
      find('.value').textContent = hit ? tell(state.shown[Math.floor(hit.faceIndex / 2)], hit) : '';
    });
    window.addEventListener('keydown', event => {
      if (event.target.tagName === 'INPUT' || event.target.tagName === 'SELECT') return;
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (step) choose((state.frame + step + about.frames) % about.frames);
      else if (event.key === ' ') { event.preventDefault(); play.click(); }
    });
  }
  // The part and the value of a face, to one 254th of the range: at an element, or at the nearest corner.
  function tell(face, hit) {
    const field = about.fields[state.field], shade = data.fields[state.field][state.frame];
    let item = face;
    if (field.place !== 'element') {
      const now = data.places[state.frame], start = data.places[0];
      const far = [0, 1, 2, 3].map(c => {
        const node = data.corners[4 * face + c];
        return [0, 1, 2].reduce((sum, i) => {
          const k = 3 * node + i, x = about.low[i] - middle[i] + about.scale[i] * (start[k] + state.swell * (now[k] - start[k]));
          return sum + (x - hit.point.getComponent(i)) ** 2;
        }, 0);
      });
      item = data.corners[4 * face + far.indexOf(Math.min(...far))];
    }
    const low = +field.labels[0], high = +field.labels[field.labels.length - 1];
    const value = shade[item] === 255 ? 'no number' : (low + (high - low) * shade[item] / 254).toPrecision(3);
    return `${about.parts[data.parts[face]]}: ${value}`;
  }

  fill();
  resize();
  look(-50, 22);
  window.addEventListener('resize', resize);
  show('Drag turns, wheel or pinch zooms, right button moves.' + (about.tools ? ' Arrow keys choose the frame, space plays.' : ''));
  box.dataset.ready = 'yes';
})();
