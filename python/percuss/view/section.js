// What a plane cuts: the sections of solids, with the colours inside.

const CELL_EDGES = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

// plane: what has a distance above 0 stays. {places, colors, elements, shades} of triangles, lines around them.
function findSection(surface, state, plane) {
  const {about, data, nodes} = surface, {normal, constant} = plane, heights = new Float32Array(about.nodes), found = {places: [], colors: [], lines: [], elements: [], shades: []};
  const tiny = 1e-7 * surface.diagonal;
  for (let n = 0; n < about.nodes; ++n) {
    const h = normal.x * nodes[3 * n] + normal.y * nodes[3 * n + 1] + normal.z * nodes[3 * n + 2] + constant;
    heights[n] = Math.abs(h) < tiny ? tiny : h;  // no node lies in the plane
  }
  const alive = data.alive && data.alive[state.frame];
  const shadeOf = (element, point) => shadeInside(surface, state, element, point);
  const colorOf = (element, shade) => (state.byPart ? surface.partColors[data.parts[element]] : surface.tables[state.field][shade]);
  for (let cell = 0; cell < about.volumes; ++cell) {
    const corners = data.cells.subarray(8 * cell, 8 * cell + 8), element = data.cellOwners[cell];
    let above = 0;
    for (let i = 0; i < 8; ++i) above += heights[corners[i]] > 0;
    if (!above || above === 8 || (alive && !alive[cell]) || state.hidden.has(data.parts[element])) continue;
    addPolygon(found, sortAround(crossEdges(surface, heights, corners), normal), element, shadeOf, colorOf);
  }
  return found;
}

function crossEdges(surface, heights, corners) {
  const points = [], done = new Set();
  for (const [i, j] of CELL_EDGES) {
    const a = Math.min(corners[i], corners[j]), b = Math.max(corners[i], corners[j]);
    if (heights[a] * heights[b] >= 0 || done.has(a * surface.about.nodes + b)) continue;
    done.add(a * surface.about.nodes + b);
    const share = heights[a] / (heights[a] - heights[b]);
    points.push({a, b, share, place: surface.placeOf(a).lerp(surface.placeOf(b), share)});
  }
  return points;
}

// In their order around their middle.
function sortAround(points, normal) {
  const middle = points.reduce((sum, p) => sum.add(p.place), new THREE.Vector3()).divideScalar(points.length || 1);
  const right = Math.abs(normal.x) < 0.7 ? new THREE.Vector3(1, 0, 0) : new THREE.Vector3(0, 1, 0), up = normal.clone().cross(right).normalize();
  right.copy(up).cross(normal);
  for (const p of points) {
    const away = p.place.clone().sub(middle);
    p.angle = Math.atan2(away.dot(up), away.dot(right));
  }
  return points.sort((p, q) => p.angle - q.angle);
}

function addPolygon(found, points, element, shadeOf, colorOf) {
  const shades = points.map(point => shadeOf(element, point));
  for (let i = 1; i + 1 < points.length; ++i) {
    found.elements.push(element);
    for (const k of [0, i, i + 1]) {
      found.places.push(...points[k].place.toArray());
      found.colors.push(...colorOf(element, shades[k]));
      found.shades.push(shades[k]);
    }
  }
  points.forEach((p, i) => found.lines.push(...p.place.toArray(), ...points[(i + 1) % points.length].place.toArray()));
}

// The shade of a node's field between those of the edge's ends.
function shadeInside(surface, state, element, point) {
  const field = surface.about.fields[state.field], shade = surface.data.fields[state.field][state.frame];
  if (field.place === 'element') return shade[element];
  const a = shade[point.a], b = shade[point.b];
  return a === 255 || b === 255 ? 255 : Math.round(a + point.share * (b - a));
}
