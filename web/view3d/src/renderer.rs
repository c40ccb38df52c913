//! Draws a scene with WebGL2.

use super::attitude::Attitude;
use super::camera::{Ball, Camera};
use super::paint::{Color, SCALE};
use super::scene::{Part, Run, STRIDE, Scene};
use super::shader::{FRAGMENT, VERTEX};
use js_sys::{Object, Reflect};
use std::f32::consts::TAU;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{
    HtmlCanvasElement, WebGl2RenderingContext as Gl, WebGlBuffer, WebGlProgram, WebGlShader,
    WebGlUniformLocation, WebGlVertexArrayObject, WebglLoseContext,
};

/// Slices per full turn.
const SLICES: f32 = 128.0;

/// WebGL program and vertices of a scene on a canvas.
pub struct Renderer {
    gl: Gl,
    program: WebGlProgram,
    buffer: WebGlBuffer,
    array: WebGlVertexArrayObject,
    at: Uniforms,
    capacity_bytes: usize,
    parts: Vec<Part>,
    ball: Ball,
}

struct Uniforms {
    view: Option<WebGlUniformLocation>,
    projection: Option<WebGlUniformLocation>,
    start: Option<WebGlUniformLocation>,
    step: Option<WebGlUniformLocation>,
    face: Option<WebGlUniformLocation>,
    nearer: Option<WebGlUniformLocation>,
    color: Option<WebGlUniformLocation>,
    by_scale: Option<WebGlUniformLocation>,
    lighting: Option<WebGlUniformLocation>,
    stops: Option<WebGlUniformLocation>,
}

/// Appearance of a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Color.
    pub color: Color,
    /// Whether it is shown.
    pub shown: bool,
}

/// Parameters of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Camera.
    pub camera: Camera,
    /// Attitude of the vehicle.
    pub attitude: Attitude,
    /// Bounding sphere that fills the view; a vehicle that grows appears larger.
    pub ball: Ball,
    /// Angle of the removed wedge, rad.
    pub cut_rad: f32,
    /// Appearance of the parts.
    pub looks: Vec<Look>,
    /// Whether the surface uses the color scale.
    pub by_scale: bool,
    /// Color of the edges of cut faces.
    pub line: Color,
    /// Background color; `None` is transparent.
    pub ground: Option<Color>,
}

impl Renderer {
    /// A renderer on a canvas.
    ///
    /// # Errors
    /// Reason why there is no WebGL2.
    pub fn new(canvas: &HtmlCanvasElement) -> Result<Renderer, String> {
        let gl = context(canvas).ok_or("this browser has no WebGL2")?;
        let program = program(&gl)?;
        let buffer = gl.create_buffer().ok_or("no buffer")?;
        let array = gl.create_vertex_array().ok_or("no vertex array")?;
        gl.bind_vertex_array(Some(&array));
        gl.bind_buffer(Gl::ARRAY_BUFFER, Some(&buffer));
        let mut offset = 0;
        for (place, numbers) in [(0, 2), (1, 2), (2, 1), (3, 1)] {
            gl.enable_vertex_attrib_array(place);
            gl.vertex_attrib_pointer_with_i32(
                place,
                numbers,
                Gl::FLOAT,
                false,
                STRIDE as i32,
                offset,
            );
            offset += 4 * numbers;
        }
        let find = |name| gl.get_uniform_location(&program, name);
        let at = Uniforms {
            view: find("view"),
            projection: find("projection"),
            start: find("start"),
            step: find("step_rad"),
            face: find("face"),
            nearer: find("nearer"),
            color: find("color"),
            by_scale: find("by_scale"),
            lighting: find("lighting"),
            stops: find("stops"),
        };
        Ok(Renderer {
            gl,
            program,
            buffer,
            array,
            at,
            capacity_bytes: 0,
            parts: Vec::new(),
            ball: Ball::default(),
        })
    }

    /// Loads the vertices of a scene; the buffer is reused if it is large enough.
    pub fn load(&mut self, scene: &Scene) {
        let gl = &self.gl;
        gl.bind_buffer(Gl::ARRAY_BUFFER, Some(&self.buffer));
        if scene.bytes.len() > self.capacity_bytes {
            gl.buffer_data_with_u8_array(Gl::ARRAY_BUFFER, &scene.bytes, Gl::DYNAMIC_DRAW);
            self.capacity_bytes = scene.bytes.len();
        } else {
            gl.buffer_sub_data_with_i32_and_u8_array(Gl::ARRAY_BUFFER, 0, &scene.bytes);
        }
        self.parts.clone_from(&scene.parts);
        self.ball = scene.ball;
    }

    /// Draws a frame.
    pub fn draw(&self, frame: &Frame) {
        self.set_up(frame);
        let gl = &self.gl;
        match frame.ground {
            Some([r, g, b]) => gl.clear_color(r, g, b, 1.0),
            None => gl.clear_color(0.0, 0.0, 0.0, 0.0),
        }
        gl.clear(Gl::COLOR_BUFFER_BIT | Gl::DEPTH_BUFFER_BIT | Gl::STENCIL_BUFFER_BIT);
        // scale colors must be readable: little shading on them
        let (lighting, by_scale) = if frame.by_scale {
            (0.5, 1.0)
        } else {
            (1.0, 0.0)
        };
        gl.uniform1f(self.at.lighting.as_ref(), lighting);
        gl.uniform1f(self.at.by_scale.as_ref(), by_scale);
        self.walls(frame);
        gl.uniform1f(self.at.by_scale.as_ref(), 0.0);
        self.faces(frame);
        self.lines(frame);
    }

    /// Frees the graphics memory.
    pub fn release(&self) {
        let extension = self.gl.get_extension("WEBGL_lose_context");
        if let Ok(Some(extension)) = extension {
            extension
                .unchecked_into::<WebglLoseContext>()
                .lose_context();
        }
    }

    fn set_up(&self, frame: &Frame) {
        let gl = &self.gl;
        let (width, height) = (gl.drawing_buffer_width(), gl.drawing_buffer_height());
        let aspect = width as f32 / height.max(1) as f32;
        gl.viewport(0, 0, width, height);
        gl.use_program(Some(&self.program));
        gl.bind_vertex_array(Some(&self.array));
        gl.enable(Gl::DEPTH_TEST);
        gl.depth_func(Gl::LEQUAL);
        gl.stencil_mask(0xff);
        let view = frame
            .attitude
            .seen(frame.camera.view(frame.ball, aspect), frame.ball);
        // keep a vehicle that has grown beyond the view inside the depth range
        let reach_m = self.ball.radius_m + (self.ball.center_m - frame.ball.center_m).abs();
        let projection = frame.camera.projection(frame.ball, aspect, reach_m);
        gl.uniform_matrix4fv_with_f32_array(self.at.view.as_ref(), false, view.as_slice());
        gl.uniform_matrix4fv_with_f32_array(
            self.at.projection.as_ref(),
            false,
            projection.as_slice(),
        );
        gl.uniform3fv_with_f32_array(self.at.stops.as_ref(), SCALE.as_flattened());
        gl.uniform1f(self.at.nearer.as_ref(), 0.0);
    }

    fn shown<'a>(&'a self, frame: &'a Frame) -> impl Iterator<Item = (&'a Part, &'a Look)> {
        let both = self.parts.iter().zip(&frame.looks);
        both.filter(|(_, look)| look.shown)
    }

    fn walls(&self, frame: &Frame) {
        let gl = &self.gl;
        gl.enable(Gl::CULL_FACE);
        let sweep = TAU - frame.cut_rad;
        let slices = (SLICES * sweep / TAU).ceil().max(1.0);
        gl.uniform1f(self.at.start.as_ref(), 0.5 * frame.cut_rad);
        gl.uniform1f(self.at.step.as_ref(), sweep / slices);
        gl.uniform1f(self.at.face.as_ref(), 0.0);
        for (part, look) in self.shown(frame) {
            gl.uniform3fv_with_f32_array(self.at.color.as_ref(), &look.color);
            let Run { first, count } = part.wall;
            gl.draw_arrays_instanced(Gl::TRIANGLES, first, count, slices as i32);
        }
        gl.disable(Gl::CULL_FACE);
    }

    /// Sets the rotation for each of the two cut faces and draws it.
    fn each_face(&self, frame: &Frame, draw: impl Fn()) {
        if frame.cut_rad <= 0.0 {
            return;
        }
        let gl = &self.gl;
        gl.uniform1f(self.at.step.as_ref(), 0.0);
        for (face, start) in [
            (-1.0, 0.5 * frame.cut_rad),
            (1.0, TAU - 0.5 * frame.cut_rad),
        ] {
            gl.uniform1f(self.at.face.as_ref(), face);
            gl.uniform1f(self.at.start.as_ref(), start);
            draw();
        }
    }

    /// Fills the cut faces: a fan over a curve covers its inside an odd number of times.
    fn faces(&self, frame: &Frame) {
        let gl = &self.gl;
        gl.enable(Gl::STENCIL_TEST);
        self.each_face(frame, || {
            for (part, look) in self.shown(frame) {
                let fans = || {
                    for face in &part.faces {
                        gl.draw_arrays(Gl::TRIANGLE_FAN, face.first, face.count);
                    }
                };
                // first pass: only the parity of the covering triangles, in the stencil buffer
                gl.color_mask(false, false, false, false);
                gl.depth_mask(false);
                gl.disable(Gl::DEPTH_TEST);
                gl.stencil_func(Gl::ALWAYS, 0, 1);
                gl.stencil_op(Gl::KEEP, Gl::KEEP, Gl::INVERT);
                fans();
                gl.color_mask(true, true, true, true);
                gl.depth_mask(true);
                gl.enable(Gl::DEPTH_TEST);
                gl.stencil_func(Gl::NOTEQUAL, 0, 1);
                // fills each pixel once, whichever triangle comes first, and clears the stencil for the next part
                gl.stencil_op(Gl::KEEP, Gl::ZERO, Gl::ZERO);
                gl.uniform3fv_with_f32_array(self.at.color.as_ref(), &look.color);
                fans();
            }
        });
        gl.disable(Gl::STENCIL_TEST);
    }

    fn lines(&self, frame: &Frame) {
        let gl = &self.gl;
        gl.uniform1f(self.at.lighting.as_ref(), 0.0);
        gl.uniform1f(self.at.nearer.as_ref(), 4e-4);
        gl.uniform3fv_with_f32_array(self.at.color.as_ref(), &frame.line);
        self.each_face(frame, || {
            for (part, _) in self.shown(frame) {
                gl.draw_arrays(Gl::LINES, part.lines.first, part.lines.count);
            }
        });
    }
}

fn context(canvas: &HtmlCanvasElement) -> Option<Gl> {
    let options = Object::new();
    for (key, value) in [
        ("stencil", JsValue::TRUE),
        ("antialias", JsValue::TRUE),
        ("alpha", JsValue::TRUE),
    ] {
        Reflect::set(&options, &key.into(), &value).ok()?;
    }
    let context = canvas.get_context_with_context_options("webgl2", &options);
    context.ok()??.dyn_into().ok()
}

fn program(gl: &Gl) -> Result<WebGlProgram, String> {
    let vertex = shader(gl, Gl::VERTEX_SHADER, VERTEX)?;
    let fragment = shader(gl, Gl::FRAGMENT_SHADER, FRAGMENT)?;
    let program = gl.create_program().ok_or("no program")?;
    gl.attach_shader(&program, &vertex);
    gl.attach_shader(&program, &fragment);
    gl.link_program(&program);
    let linked = gl.get_program_parameter(&program, Gl::LINK_STATUS);
    if linked.as_bool() == Some(true) {
        Ok(program)
    } else {
        Err(gl.get_program_info_log(&program).unwrap_or_default())
    }
}

fn shader(gl: &Gl, kind: u32, text: &str) -> Result<WebGlShader, String> {
    let shader = gl.create_shader(kind).ok_or("no shader")?;
    gl.shader_source(&shader, text);
    gl.compile_shader(&shader);
    let compiled = gl.get_shader_parameter(&shader, Gl::COMPILE_STATUS);
    if compiled.as_bool() == Some(true) {
        Ok(shader)
    } else {
        Err(gl.get_shader_info_log(&shader).unwrap_or_default())
    }
}
