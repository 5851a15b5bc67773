// Rigid walls: a plane as a plate with short lines on the side that no body enters, a cylinder or a sphere as many plates. A plane is
// seen through from behind.

const WALL = 0xc9d0d6, WALL_EDGE = 0x7d868f;

const WALL_BEHIND = 0.25;  // opacity of a plane that is seen from behind

const STROKES = 20, STROKE = 0.02;  // along each side of a plane; their length, of the diagonal

class Walls {
  constructor(viewer) {
    Object.assign(this, {viewer, tick: viewer.find('.walls'), shown: []});
    this.shapes = (viewer.about.walls || []).map(wall => this.makeShapes(wall));
    if (!this.shapes.length) this.tick.parentElement.style.display = 'none';
    this.tick.addEventListener('change', () => { this.changed(); viewer.draw(); });
    this.changed();
  }

  makeShapes(wall) {
    const corners = wall.plates.map((x, i) => x - this.viewer.surface.middle[i % 3]);
    const plate = new THREE.BufferGeometry(), lines = new THREE.BufferGeometry();
    plate.setAttribute('position', new THREE.BufferAttribute(new Float32Array(addTriangles(corners)), 3));
    plate.computeVertexNormals();
    lines.setAttribute('position', new THREE.BufferAttribute(new Float32Array(wall.normal ? addStrokes(corners, wall.normal, STROKE * this.viewer.surface.diagonal) : []), 3));
    return {wall, corners, plate, lines};
  }

  // How far a wall has moved in the frame that is shown; as displacements it is scaled.
  findMove({moves}) {
    const {state} = this.viewer;
    return new THREE.Vector3(...(moves.length ? moves[state.frame] : [0, 0, 0])).multiplyScalar(state.swell);
  }

  // The walls as they stand now, and their mirrored images.
  changed() {
    const {viewer} = this;
    if (viewer.painter) return;
    viewer.scene.remove(...this.shown.splice(0).map(one => one.group));
    if (!this.tick.checked) return;
    for (const {wall, corners, plate, lines} of this.shapes) {
      for (const copy of viewer.copies) {
        const group = new THREE.Group(), material = new THREE.MeshLambertMaterial({color: WALL, side: THREE.DoubleSide, transparent: true});
        group.add(new THREE.Mesh(plate, material), new THREE.LineSegments(lines, new THREE.LineBasicMaterial({color: WALL_EDGE})));
        setMatrix(group, copy.matrixWorld.clone().multiply(new THREE.Matrix4().setPosition(this.findMove(wall))));
        for (const child of group.children) child.frustumCulled = false;
        viewer.scene.add(group);
        this.shown.push({group, material, plane: wall.normal && makePlane(wall.normal, corners).applyMatrix4(group.matrix)});
      }
    }
  }

  // A plane that the camera is behind of is drawn after the bodies, which are then seen through it.
  drawn() {
    for (const {group, material, plane} of this.shown) {
      const behind = Boolean(plane) && plane.distanceToPoint(this.viewer.camera.position) < 0;
      material.opacity = behind ? WALL_BEHIND : 1;
      material.depthWrite = !behind;
      group.children[0].renderOrder = behind ? 1 : 0;
    }
  }

  // For pictures without WebGL: [{corners [4], behind}], first planes that are seen from in front, behind which is no body.
  list() {
    const found = [];
    for (const {wall, corners} of this.tick.checked ? this.shapes : []) {
      for (const copy of this.viewer.copies) {
        const matrix = copy.matrixWorld.clone().multiply(new THREE.Matrix4().setPosition(this.findMove(wall)));
        const behind = Boolean(wall.normal) && makePlane(wall.normal, corners).applyMatrix4(matrix).distanceToPoint(this.viewer.camera.position) < 0;
        for (let i = 0; i < corners.length; i += 12) {
          found.push({corners: [0, 3, 6, 9].map(k => new THREE.Vector3().fromArray(corners, i + k).applyMatrix4(matrix)), behind, isPlane: Boolean(wall.normal)});
        }
      }
    }
    return found;
  }
}

const makePlane = (normal, corners) => new THREE.Plane().setFromNormalAndCoplanarPoint(new THREE.Vector3(...normal), new THREE.Vector3().fromArray(corners));

// The outline of a plate of four corners, and strokes from it to the side that its normal does not point to.
function addStrokes(corners, normal, length) {
  const lines = [], [a, b, c, d] = [0, 3, 6, 9].map(k => new THREE.Vector3().fromArray(corners, k)), away = new THREE.Vector3(...normal).negate();
  for (const [from, to] of [[a, b], [b, c], [c, d], [d, a]]) {
    const along = to.clone().sub(from), slope = away.clone().sub(along.clone().normalize()).multiplyScalar(length);
    lines.push(...from.toArray(), ...to.toArray());
    for (let k = 1; k <= STROKES; ++k) {
      const foot = from.clone().addScaledVector(along, k / STROKES);
      lines.push(...foot.toArray(), ...foot.clone().add(slope).toArray());
    }
  }
  return lines;
}
