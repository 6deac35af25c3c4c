// ---- What every drawing in space needs of WebGL 2.
/** @type {WebGL2RenderingContext} */
let gl;

/** @type {(kind: number, text: string) => WebGLShader} */
function compiled(kind, text) {
  const shader = gl.createShader(kind);
  if (!shader) throw new Error('a shader cannot be made');
  gl.shaderSource(shader, text);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(shader) ?? '');
  return shader;
}

/** A program with the places of its uniforms by name; attributes have the places given. @type {(vertex: string, fragment: string, attributes: string[]) => Shader} */
function programOf(vertex, fragment, attributes) {
  const program = gl.createProgram();
  /** @type {Shader['uniforms']} */
  const uniforms = {};
  gl.attachShader(program, compiled(gl.VERTEX_SHADER, vertex));
  gl.attachShader(program, compiled(gl.FRAGMENT_SHADER, fragment));
  attributes.forEach((name, k) => gl.bindAttribLocation(program, k, name));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(program) ?? '');
  const count_ = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
  for (let k = 0; k < count_; ++k) {
    const name = gl.getActiveUniform(program, k)?.name;
    if (name) uniforms[name] = gl.getUniformLocation(program, name);
  }
  return {program, uniforms};
}

/** By the length of the vector. @type {Record<number, (place: WebGLUniformLocation | null, v: number[] | Float32Array) => void>} */
const SETTERS = {
  2: (place, v) => gl.uniform2fv(place, v),
  3: (place, v) => gl.uniform3fv(place, v),
  4: (place, v) => gl.uniform4fv(place, v),
  16: (place, v) => gl.uniformMatrix4fv(place, false, v)
};

/**
 * Uses a program with these values; whole numbers come as {i: value}. What the program does not have is passed over.
 * @type {(made: Shader, values: UniformValues) => void}
 */
function use(made, values) {
  gl.useProgram(made.program);
  for (const [name, value] of Object.entries(values)) {
    const place = made.uniforms[name];
    if (place === undefined) continue;
    if (typeof value === 'number') gl.uniform1f(place, value);
    else if ('i' in value) gl.uniform1i(place, value.i);
    else SETTERS[value.length](place, value);
  }
}

/** @type {(target: number, data?: Float32Array, usage?: number) => WebGLBuffer} */
function bufferOf(target, data, usage) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(target, buffer);
  if (data) gl.bufferData(target, data, usage || gl.STATIC_DRAW);
  return buffer;
}

/** @type {(unit_: number, internal: number, w: number, h: number, format: number, type: number, data: ArrayBufferView) => WebGLTexture} */
function textureOf(unit_, internal, w, h, format, type, data) {
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0 + unit_);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
  for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  gl.texImage2D(gl.TEXTURE_2D, 0, internal, w, h, 0, format, type, data);
  return texture;
}

/** @type {Map<string, number[]>} */
const channels = new Map();
/** A colour of the page's style as red, green and blue from 0 to 1. @type {(color: string) => number[]} */
function rgb(color) {
  const known = channels.get(color);
  if (known) return known;
  const canvas = document.createElement('canvas'), c = contextOf(canvas, {willReadFrequently: true});
  canvas.width = canvas.height = 1;
  c.fillStyle = color;
  c.fillRect(0, 0, 1, 1);
  const found = [...c.getImageData(0, 0, 1, 1).data.slice(0, 3)].map(v => v / 255);
  channels.set(color, found);
  return found;
}
