// The surface of a frame as triangles, edges and beams: four corners a face, whose places and colours change from frame to frame.

const SMOOTH = 0.87;  // cosine between faces whose edge is no line of the outline

class Surface {
  constructor(about, data) {
    this.about = about;
    this.data = data;
    this.size = about.scale.map(s => s * 65535);
    this.diagonal = Math.hypot(...this.size);
    this.middle = about.low.map((l, i) => l + this.size[i] / 2);
    this.tables = about.fields.map(field => makeColors(field.map));
    this.partColors = about.partColors.map(text => rgb(text).map(c => Math.round(255 * c)));
    this.nodes = new Float32Array(3 * about.nodes);  // where they are shown
    this.shown = [];  // faces
    this.places = new THREE.BufferAttribute(new Float32Array(12 * about.faces), 3);
    this.colors = new THREE.BufferAttribute(new Uint8Array(12 * about.faces), 3, true);
    [this.triangles, this.edges, this.beams] = [6, 8, 2].map(count => {
      const shape = new THREE.BufferGeometry();
      shape.setAttribute('position', this.places);
      shape.setAttribute('color', this.colors);
      shape.setIndex(new THREE.BufferAttribute(new Uint32Array(count * about.faces), 1));
      shape.boundingSphere = new THREE.Sphere(new THREE.Vector3(), Infinity);
      return shape;
    });
  }

  isBeam(face) {
    return this.data.corners[4 * face + 1] === this.data.corners[4 * face + 2];
  }

  fill(state) {
    this.move(state);
    const {corners, owners} = this.data, {nodes} = this, places = this.places.array, colors = this.colors.array;
    const field = this.about.fields[state.field], shade = this.data.fields[state.field][state.frame];
    const table = state.byPart ? this.partColors : this.tables[state.field], ofNodes = !state.byPart && field.place !== 'element';
    for (let c = 0, to = 0, end = corners.length; c < end; ++c) {
      const node = corners[c], owner = owners[c >> 2], from = 3 * node;
      const color = table[state.byPart ? this.data.parts[owner] : shade[ofNodes ? node : owner]];
      places[to] = nodes[from];
      colors[to++] = color[0];
      places[to] = nodes[from + 1];
      colors[to++] = color[1];
      places[to] = nodes[from + 2];
      colors[to++] = color[2];
    }
    this.places.needsUpdate = this.colors.needsUpdate = true;
    this.choose(state);
  }

  move(state) {
    const {low, scale} = this.about, {middle, nodes} = this, {swell} = state;
    const start = this.data.places[0], now = this.data.places[state.frame];
    for (let k = 0, i = 0; k < nodes.length; ++k, i = i === 2 ? 0 : i + 1) nodes[k] = low[i] - middle[i] + scale[i] * (start[k] + swell * (now[k] - start[k]));
  }

  // The faces that are seen change where elements fail, or parts are hidden.
  choose(state) {
    const seen = this.data.visible && this.data.visible[state.frame], key = [...state.hidden].join() + (seen ? `/${state.frame}` : '');
    if (key === this.key) return;
    this.key = key;
    this.shown = [];
    const indexes = [this.triangles, this.edges, this.beams].map(shape => shape.index.array), ends = [0, 0, 0];
    const put = (which, first, ...corners) => { for (const c of corners) indexes[which][ends[which]++] = first + c; };
    for (let f = 0; f < this.about.faces; ++f) {
      if ((seen && !seen[f]) || state.hidden.has(this.data.parts[this.data.owners[f]])) continue;
      if (this.isBeam(f)) {
        put(2, 4 * f, 0, 1);
        continue;
      }
      this.shown.push(f);
      put(0, 4 * f, 0, 1, 2, 0, 2, 3);
      put(1, 4 * f, 0, 1, 1, 2, 2, 3, 3, 0);
    }
    [this.triangles, this.edges, this.beams].forEach((shape, which) => {
      shape.setDrawRange(0, ends[which]);
      shape.index.needsUpdate = true;
    });
  }

  placeOf(node) {
    return new THREE.Vector3().fromArray(this.nodes, 3 * node);
  }

  // A place of the run as it is shown.
  show(start, now, swell) {
    return new THREE.Vector3(...start.map((x, i) => x + swell * (now[i] - x) - this.middle[i]));
  }

  // Lines of the first frame: edges of one face, or of faces at an angle.
  makeOutline() {
    const {corners} = this.data, start = this.data.places[0], normals = [];
    const at = node => new THREE.Vector3(...[0, 1, 2].map(i => this.about.low[i] - this.middle[i] + this.about.scale[i] * start[3 * node + i]));
    const open = new Map(), lines = [], seen = this.data.visible && this.data.visible[0];
    for (let f = 0; f < this.about.faces; ++f) {
      if (seen && !seen[f]) continue;
      const [a, b, c, d] = [0, 1, 2, 3].map(i => corners[4 * f + i]);
      if (b === c) {
        lines.push(...at(a).toArray(), ...at(b).toArray());
        continue;
      }
      normals[f] = at(c).sub(at(a)).cross(at(d).sub(at(b))).normalize();
      if (c === d) normals[f] = at(b).sub(at(a)).cross(at(c).sub(at(a))).normalize();
      for (const [p, q] of [[a, b], [b, c], [c, d], [d, a]]) {
        if (p === q) continue;
        const key = Math.min(p, q) * this.about.nodes + Math.max(p, q), other = open.get(key);
        if (other === undefined) open.set(key, f);
        else if (other >= 0 && Math.abs(normals[other].dot(normals[f])) > SMOOTH) open.set(key, -1);
      }
    }
    for (const [key, face] of open) {
      if (face < 0) continue;
      lines.push(...at(Math.floor(key / this.about.nodes)).toArray(), ...at(key % this.about.nodes).toArray());
    }
    return new Float32Array(lines);
  }
}
