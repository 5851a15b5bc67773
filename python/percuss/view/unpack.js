// What surface.py has packed: pieces in its order.

async function unpack(text) {
  const letters = atob(text), packed = new Uint8Array(letters.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Rows of differences become rows of values.
function addRows(values, width) {
  for (let i = width; i < values.length; ++i) values[i] += values[i - width];
  return values;
}

function readPack(about, bytes) {
  let at = 0;
  const take = (Type, count) => new Type(bytes.slice(at, at += count * Type.BYTES_PER_ELEMENT).buffer);
  const takeRows = (Type, rows, width) => addRows(take(Type, rows * width), width);
  const splitFrames = (values, width) => Array.from({length: about.frames}, (_, f) => values.subarray(f * width, (f + 1) * width));
  const data = {corners: takeRows(Uint32Array, about.faces, 4), owners: takeRows(Uint32Array, about.faces, 1),
    parts: take(Uint16Array, about.elements), elementIds: takeRows(Uint32Array, about.elements, 1), nodeIds: takeRows(Uint32Array, about.nodes, 1),
    cells: takeRows(Uint32Array, about.volumes, 8), cellOwners: takeRows(Uint32Array, about.volumes, 1)};
  const numbers = 3 * about.nodes;
  data.places = [];
  for (let f = 0; f < about.frames; ++f) {
    const low = take(Uint8Array, numbers), high = take(Uint8Array, numbers), now = new Uint16Array(numbers);
    for (let i = 0; i < numbers; ++i) now[i] = low[i] + 256 * high[i] + (f ? data.places[f - 1][i] : 0);
    data.places.push(now);
  }
  data.fields = about.fields.map(field => {
    const width = field.place === 'element' ? about.elements : about.nodes;
    return splitFrames(takeRows(Uint8Array, about.frames, width), width);
  });
  data.visible = about.erodes ? splitFrames(takeRows(Uint8Array, about.frames, about.faces), about.faces) : null;
  data.alive = about.erodes ? splitFrames(takeRows(Uint8Array, about.frames, about.volumes), about.volumes) : null;
  data.arrows = about.arrows.map(one => ({nodes: take(Uint32Array, one.count), frames: splitFrames(take(Int16Array, 3 * one.count * about.frames), 3 * one.count)}));
  return data;
}

const rgb = text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255);

// Colours of the bytes 0 to 254, and of 255, which is no number.
// first, last: the shades at the ends of the map; what lies beyond has their colours.
function makeColors(map, first = 0, last = 254) {
  const stops = map.map(rgb), table = [];
  for (let i = 0; i < 255; ++i) {
    const x = Math.min(Math.max((i - first) / (last - first), 0), 1) * (stops.length - 1), k = Math.min(Math.floor(x), stops.length - 2);
    table.push(stops[k].map((c, j) => Math.round(255 * (c + (x - k) * (stops[k + 1][j] - c)))));
  }
  table.push([255, 0, 255]);
  return table;
}
