// ---- Programs for the graphics processor. The heights are a texture of one float for each cell. Where nothing is cut open, hidden or red, the
// same colours come from less: PLAIN. A processor that stands in for a graphics processor takes half as long for it.
/** @type {(text: string) => string} */
const plainOf = text => text.replace('\n', '\n#define PLAIN\n');
const TILE = 32;  // cells on each side of the largest pieces of the surface

const SURFACE_VERTEX = `#version 300 es
precision highp float;
uniform mat4 view; uniform vec4 grid, edges, block; uniform vec3 light; uniform float level, bottom, under;
in vec2 corner; in float altitude; in vec3 normal; in vec4 tint;
out vec3 place, shade; out float top;
void main() {
  top = altitude;
  vec2 c = corner / 16.0, p = grid.xy + vec2(c.x + 0.5, -c.y - 0.5) * grid.z;
  if (c.x < block.x + 0.1) p.x = edges.x;
  if (c.x > block.z - 0.1) p.x = edges.z;
  if (c.y < block.y + 0.1) p.y = edges.w;
  if (c.y > block.w - 0.1) p.y = edges.y;
  place = vec3(p, under > 0.5 ? bottom : min(top, level));
  shade = tint.rgb * (under > 0.5 ? 0.6 : 0.55 + 0.5 * max(0.0, dot(normalize(normal), light)));
  gl_Position = view * vec4(place, 1.0);
}`;

const SURFACE_FRAGMENT = `#version 300 es
precision highp float; precision highp int; precision highp sampler2D;
uniform sampler2D rests; uniform vec4 section, grid, hole; uniform vec3 capColor, restColor; uniform float level, bottom, under; uniform int showRests;
in vec3 place, shade; in float top;
out vec4 color;
void main() {
#ifdef PLAIN
  if (top <= bottom + 1e-4) discard;
  color = vec4(shade, 1.0);
#else
  if (top <= bottom + 1e-4 || dot(section.xyz, place) > section.w || all(greaterThanEqual(place.xy, hole.xy)) && all(lessThanEqual(place.xy, hole.zw))) discard;
  color = vec4(top > level + 1e-4 && under < 0.5 ? capColor : shade, 1.0);
  if (showRests == 1 && texelFetch(rests, ivec2(vec2(place.x - grid.x, grid.y - place.y) / grid.z), 0).a > 0.5) color = vec4(restColor, 1.0);
#endif
}`;

/** Upright faces from the surface down to the bottom: the sides of the stock and the face of a section. */
const WALL_VERTEX = `#version 300 es
precision highp float; precision highp int; precision highp sampler2D;
uniform mat4 view; uniform sampler2D heights; uniform vec4 block, grid, edges; uniform float level, bottom, at; uniform int along, every;
out vec3 place; out float run;
float height(ivec2 c) { return texelFetch(heights, clamp(c, ivec2(block.xy), ivec2(block.zw)), 0).r; }
void main() {
  int k = gl_VertexID / 2 * every;
  ivec2 c; vec2 p; float h;
  if (along == 0) {
    float row = (grid.y - at) / grid.z - 0.5;
    c = ivec2(min(int(block.x) + k, int(block.z)), int(floor(row)));
    h = mix(height(c), height(c + ivec2(0, 1)), fract(row));
    p = vec2(k == 0 ? edges.x : float(c.x) == block.z ? edges.z : grid.x + (float(c.x) + 0.5) * grid.z, at);
    run = p.x;
  } else {
    float column = (at - grid.x) / grid.z - 0.5;
    c = ivec2(int(floor(column)), min(int(block.y) + k, int(block.w)));
    h = mix(height(c), height(c + ivec2(1, 0)), fract(column));
    p = vec2(at, k == 0 ? edges.w : float(c.y) == block.w ? edges.y : grid.y - (float(c.y) + 0.5) * grid.z);
    run = p.y;
  }
  place = vec3(p, gl_VertexID % 2 == 0 ? bottom : max(bottom, min(h, level)));
  gl_Position = view * vec4(place, 1.0);
}`;

const WALL_FRAGMENT = `#version 300 es
precision highp float; precision highp sampler2D;
uniform sampler2D palette; uniform vec4 section, hole; uniform vec3 capColor; uniform vec2 range; uniform float shade, hatch;
in vec3 place; in float run;
out vec4 color;
void main() {
#ifndef PLAIN
  if (all(greaterThanEqual(place.xy, hole.xy)) && all(lessThanEqual(place.xy, hole.zw))) discard;
  if (hatch > 0.0) {
    float line = fract((run + place.z) / hatch);
    color = vec4(capColor * (line < 0.14 ? 0.72 : 1.0), 1.0);
    return;
  }
  if (dot(section.xyz, place) > section.w) discard;
#endif
  color = vec4(texture(palette, vec2((place.z - range.x) / (range.y - range.x), 0.5)).rgb * shade, 1.0);
}`;

const LINE_VERTEX = `#version 300 es
precision highp float; precision highp int;
uniform mat4 view; uniform int last, trail;
in vec3 position; in vec4 tint; in int owner;
out vec4 ink; out vec3 place;
void main() {
  ink = tint;
  if (trail > 0) ink.a *= 0.25 + 0.75 * clamp(1.0 - float(last - owner) / float(trail), 0.0, 1.0);
  place = position;
  gl_Position = view * vec4(position, 1.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 section; uniform float strength, level;
in vec4 ink; in vec3 place;
out vec4 color;
void main() {
#ifndef PLAIN
  if (dot(section.xyz, place) > section.w + 1e-3 || place.z > level + 1e-3) discard;
#endif
  color = vec4(ink.rgb, ink.a * strength);
}`;

const CUTTER_VERTEX = `#version 300 es
precision highp float;
uniform mat4 view; uniform vec3 tip;
in vec3 position; in vec3 outward; in float kind;
out vec3 normal; out float part;
void main() { normal = outward; part = kind; gl_Position = view * vec4(position + tip, 1.0); }`;

const CUTTER_FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 light, edgeColor; uniform float strength;
in vec3 normal; in float part;
out vec4 color;
void main() {
  vec3 base = part < 0.5 ? edgeColor : part < 1.5 ? vec3(0.56, 0.6, 0.65) : vec3(0.36, 0.42, 0.52);
  color = vec4(base * (0.5 + 0.55 * max(0.0, dot(normalize(normal), light))), strength);
}`;
