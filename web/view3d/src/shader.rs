//! Shaders.

/// Revolves a half-section about the axis: one instance per slice.
pub const VERTEX: &str = "#version 300 es
precision highp float;
layout(location = 0) in vec2 point;    // x, r, m
layout(location = 1) in vec2 normal;   // along x, away from the axis
layout(location = 2) in float value;   // on the scale, negative: none
layout(location = 3) in float side;    // 0 or 1: where the slice starts or ends
uniform mat4 view;
uniform mat4 projection;
uniform float start;                   // angle of the first slice, rad
uniform float step_rad;                // angle of a slice, rad
uniform float face;                    // 0: a wall; -1, 1: a cut face at the start, at the end
uniform float nearer;                  // how much is drawn before what lies in the same place
out vec3 seen_normal;
out vec3 seen_point;
out float painted;
void main() {
  float angle = start + (float(gl_InstanceID) + side) * step_rad;
  vec2 around = vec2(sin(angle), cos(angle));
  vec3 place = vec3(point.y * around.x, point.x, point.y * around.y);
  vec3 out_of = face == 0.0
    ? vec3(normal.y * around.x, normal.x, normal.y * around.y)
    : face * vec3(around.y, 0.0, -around.x);
  vec4 seen = view * vec4(place, 1.0);
  seen_point = seen.xyz;
  seen_normal = mat3(view) * out_of;
  painted = value;
  gl_Position = projection * seen;
  gl_Position.z -= nearer * gl_Position.w;
}
";

/// One light from above the camera's left, one from below, and a weak specular highlight.
pub const FRAGMENT: &str = "#version 300 es
precision highp float;
in vec3 seen_normal;
in vec3 seen_point;
in float painted;
uniform vec3 color;
uniform float by_scale;                // 1: colors of the scale where there is a value
uniform float lighting;                // 0: the plain color
uniform vec3 stops[6];
out vec4 shown;
vec3 on_scale(float value) {
  float at = clamp(value, 0.0, 1.0) * 5.0;
  int i = int(min(at, 4.0));
  return mix(stops[i], stops[i + 1], at - float(i));
}
void main() {
  vec3 base = by_scale > 0.5 && painted >= 0.0 ? on_scale(painted) : color;
  vec3 n = normalize(seen_normal);
  vec3 to_eye = normalize(-seen_point);
  float key = max(dot(n, normalize(vec3(-0.45, 0.55, 0.75))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.7, -0.6, 0.4))), 0.0);
  float gloss = pow(max(dot(n, normalize(normalize(vec3(-0.45, 0.55, 0.75)) + to_eye)), 0.0), 40.0);
  vec3 lit = base * (0.46 + 0.52 * key + 0.16 * fill) + vec3(0.10 * gloss);
  shown = vec4(mix(base, lit, lighting), 1.0);
}
";
