// Draws the surface without WebGL, on a plain canvas: the farthest face first.

class Painter {
  constructor(canvas, surface) {
    this.canvas = canvas;
    this.surface = surface;
    this.pen = canvas.getContext('2d');
  }

  setSize(width, height) {
    [this.canvas.width, this.canvas.height] = [width, height];
  }

  // edges, beams: whether they are drawn. copies: places of mirrored halves, as matrices. plane: faces whose middle is below it are left out.
  // walls: plates of rigid walls (walls.js).
  paint(camera, {edges, copies, plane, walls}) {
    const {surface, pen, canvas} = this, {data, about} = surface;
    camera.updateMatrixWorld();
    const back = new THREE.Vector3(0, 0, 1).applyQuaternion(camera.quaternion), faces = [];
    const projection = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse), spot = new THREE.Vector3();
    copies.forEach(matrix => {
      const screen = new Float32Array(2 * about.nodes), depth = new Float32Array(about.nodes), world = new Float32Array(3 * about.nodes);
      for (let n = 0; n < about.nodes; ++n) {
        spot.fromArray(surface.nodes, 3 * n).applyMatrix4(matrix).toArray(world, 3 * n);
        depth[n] = spot.clone().sub(camera.position).dot(back);
        spot.applyMatrix4(projection);
        screen[2 * n] = (spot.x + 1) / 2 * canvas.width;
        screen[2 * n + 1] = (1 - spot.y) / 2 * canvas.height;
      }
      const range = surface.beams.drawRange.count, beams = surface.beams.index.array.slice(0, range).filter((_, i) => i % 2 === 0).map(i => i >> 2);
      for (const f of [...surface.shown, ...beams]) {
        const nodes = [...data.corners.subarray(4 * f, 4 * f + 4)], mean = k => nodes.reduce((sum, n) => sum + world[3 * n + k], 0) / 4;
        if (plane && plane.distanceToPoint(new THREE.Vector3(mean(0), mean(1), mean(2))) < 0) continue;
        faces.push({f, nodes, screen, world, depth: nodes.reduce((sum, n) => sum + depth[n], 0) / 4});
      }
    });
    const project = point => {
      const {x, y} = point.clone().applyMatrix4(projection);
      return [(x + 1) / 2 * canvas.width, (1 - y) / 2 * canvas.height];
    };
    const plates = walls.map(wall => ({...wall, outline: wall.corners.map(project),
      depth: wall.corners.reduce((sum, corner) => sum + corner.clone().sub(camera.position).dot(back), 0) / 4}));
    faces.push(...plates.filter(plate => !plate.isPlane));
    faces.sort((p, q) => p.depth - q.depth);
    pen.fillStyle = '#ffffff';
    pen.fillRect(0, 0, canvas.width, canvas.height);
    this.lights = LIGHTS.map(([x, y, z, strength]) => ({along: new THREE.Vector3(x, y, z).normalize().applyQuaternion(camera.quaternion), strength}));
    for (const plate of plates) if (plate.isPlane && !plate.behind) this.paintPlate(plate);
    for (const face of faces) {
      if (face.outline) this.paintPlate(face);
      else this.paintFace(face, back, edges);
    }
    for (const plate of plates) if (plate.behind) this.paintPlate(plate);
  }

  paintPlate({outline, behind, isPlane}) {
    const {pen} = this, colors = [WALL, WALL_EDGE].map(color => new THREE.Color(color).getStyle());
    pen.globalAlpha = behind ? WALL_BEHIND : 1;
    pen.beginPath();
    outline.forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.closePath();
    pen.fillStyle = colors[0];
    pen.strokeStyle = colors[isPlane ? 1 : 0];
    pen.fill();
    pen.stroke();
    pen.globalAlpha = 1;
  }

  paintFace({f, nodes, screen, world}, back, edges) {
    const {pen, surface} = this, colors = surface.colors.array;
    const corner = k => new THREE.Vector3().fromArray(world, 3 * nodes[k]);
    const normal = corner(2).sub(corner(0)).cross((nodes[2] === nodes[3] ? corner(1).sub(corner(0)) : corner(3).sub(corner(1)))).normalize();
    if (normal.dot(back) < 0) normal.negate();
    const light = surface.isBeam(f) ? 1 : this.lights.reduce((sum, {along, strength}) => sum + strength * Math.max(0, normal.dot(along)), AMBIENT);
    const color = [0, 1, 2].map(i => Math.round(light * [0, 1, 2, 3].reduce((sum, k) => sum + colors[12 * f + 3 * k + i], 0) / 4));
    pen.beginPath();
    nodes.forEach((n, k) => (k ? pen.lineTo(screen[2 * n], screen[2 * n + 1]) : pen.moveTo(screen[2 * n], screen[2 * n + 1])));
    pen.closePath();
    pen.fillStyle = pen.strokeStyle = `rgb(${color})`;
    pen.fill();
    pen.lineWidth = surface.isBeam(f) ? 2 : 0.7;  // without it the white between faces is seen
    if (edges && !surface.isBeam(f)) pen.strokeStyle = 'rgba(74, 79, 87, 0.35)';
    pen.stroke();
  }
}
