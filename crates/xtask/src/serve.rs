//! Builds the app and serves it to browsers on this machine.

use std::{
    fs,
    io::{self, BufRead, BufReader, Read, Write},
    net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream},
    path::{Component, Path, PathBuf},
    thread,
    time::{Duration, Instant},
};

use anyhow::{Context, Result};

use crate::{build, project::Project};

/// Default port.
pub const DEFAULT_PORT: u16 = 8080;
/// Largest number of connections at a time: a browser opens six, some of them before it needs them.
const CONNECTIONS: usize = 32;
/// Longest time for one request and its answer.
const LONGEST: Duration = Duration::from_secs(10);

/// Builds the app and serves it until the program is interrupted.
pub fn run(project: &Project, port: u16) -> Result<()> {
    build::dist(project)?;
    let listener = listen(port)?;
    let address = listener.local_addr()?;
    if address.port() != port {
        println!("\nPort {port} is taken.");
    }
    println!("\nM-SAPE is at http://{address}/  (Ctrl-C ends it)");
    accept(&listener, &project.dist);
    Ok(())
}

/// Serves a folder in the background, as long as this program runs.
pub fn in_background(folder: &Path) -> Result<SocketAddr> {
    let listener = listen(0)?;
    let address = listener.local_addr()?;
    let folder = folder.to_owned();
    thread::spawn(move || accept(&listener, &folder));
    Ok(address)
}

/// Listens on a local port, or on any free one if that is taken.
fn listen(port: u16) -> Result<TcpListener> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port))
        .or_else(|_| TcpListener::bind((Ipv4Addr::LOCALHOST, 0)))
        .context("no port is free on 127.0.0.1")
}

/// Answers connections, so many at a time and no more.
fn accept(listener: &TcpListener, folder: &Path) {
    thread::scope(|scope| {
        for _ in 0..CONNECTIONS {
            scope.spawn(|| {
                for stream in listener.incoming().flatten() {
                    // a browser that disconnects, or is slow, is not our error
                    answer(&stream, folder).ok();
                }
            });
        }
    });
}

/// Connection that ends at a time.
struct Bounded<'s> {
    stream: &'s TcpStream,
    end: Instant,
}

impl Bounded<'_> {
    /// Time that is left; never zero, which would be no bound.
    fn left(&self) -> io::Result<Option<Duration>> {
        let left = self.end.saturating_duration_since(Instant::now());
        match left.is_zero() {
            true => Err(io::ErrorKind::TimedOut.into()),
            false => Ok(Some(left)),
        }
    }
}

impl Read for Bounded<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.stream.set_read_timeout(self.left()?)?;
        self.stream.read(buffer)
    }
}

impl Write for Bounded<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.stream.set_write_timeout(self.left()?)?;
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}

/// Answers one request and closes the connection.
fn answer(stream: &TcpStream, folder: &Path) -> io::Result<()> {
    let end = Instant::now() + LONGEST;
    let mut stream = Bounded { stream, end };
    let mut request = String::new();
    let mut lines = BufReader::new((&mut stream).take(16_384));
    lines.read_line(&mut request)?;
    let mut header = String::new();
    while lines.read_line(&mut header)? > 2 {
        header.clear();
    }
    let mut words = request.split_ascii_whitespace();
    let (method, target) = (words.next().unwrap_or(""), words.next().unwrap_or(""));
    let response = match method {
        "GET" | "HEAD" => Response::to(target, folder),
        _ => Response::text("405 Method Not Allowed", "only GET and HEAD\n"),
    };
    stream.write_all(response.head().as_bytes())?;
    if method != "HEAD" {
        stream.write_all(&response.content)?;
    }
    Ok(())
}

struct Response {
    status: &'static str,
    media_type: &'static str,
    cache: &'static str,
    content: Vec<u8>,
}

impl Response {
    fn to(target: &str, folder: &Path) -> Self {
        let Some((file, content)) = find(folder, target) else {
            return Self::text("404 Not Found", "no such file\n");
        };
        // folders named by their content can be cached: see build.rs
        let lasting = target.starts_with("/code-");
        Self {
            status: "200 OK",
            media_type: media_type(&file),
            cache: if lasting {
                "max-age=31536000, immutable"
            } else {
                "no-cache"
            },
            content,
        }
    }

    fn text(status: &'static str, content: &str) -> Self {
        let content = content.as_bytes().to_vec();
        Self {
            status,
            media_type: "text/plain; charset=utf-8",
            cache: "no-store",
            content,
        }
    }

    fn head(&self) -> String {
        let Self {
            status,
            media_type,
            cache,
            content,
        } = self;
        format!(
            "HTTP/1.1 {status}\r\nContent-Type: {media_type}\r\nContent-Length: {}\r\nCache-Control: {cache}\r\n\
             X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n",
            content.len()
        )
    }
}

/// File path and content for a request target.
fn find(folder: &Path, target: &str) -> Option<(PathBuf, Vec<u8>)> {
    let mut file = folder.join(inside(target)?);
    if file.is_dir() {
        file.push("index.html");
    }
    let content = fs::read(&file).ok()?;
    Some((file, content))
}

/// A request target as a relative path that cannot leave the folder.
fn inside(target: &str) -> Option<PathBuf> {
    let path = target.split(['?', '#']).next()?.strip_prefix('/')?;
    let path = PathBuf::from(decoded(path)?);
    path.components()
        .all(|part| matches!(part, Component::Normal(_)))
        .then_some(path)
}

/// Text with percent-encoding decoded.
fn decoded(text: &str) -> Option<String> {
    let mut parts = text.split('%');
    let mut bytes = parts.next()?.as_bytes().to_vec();
    for part in parts {
        bytes.push(u8::from_str_radix(part.get(..2)?, 16).ok()?);
        bytes.extend_from_slice(part.get(2..)?.as_bytes());
    }
    String::from_utf8(bytes).ok()
}

fn media_type(file: &Path) -> &'static str {
    match file.extension().and_then(|extension| extension.to_str()) {
        Some("css") => "text/css; charset=utf-8",
        Some("csv") => "text/csv; charset=utf-8",
        Some("html") => "text/html; charset=utf-8",
        Some("ico") => "image/x-icon",
        Some("js" | "mjs") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("png") => "image/png",
        Some("svg") => "image/svg+xml",
        Some("toml" | "txt" | "md") => "text/plain; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("webmanifest") => "application/manifest+json",
        Some("woff2") => "font/woff2",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_target_stays_inside_the_folder() {
        assert_eq!(inside("/a/b%20c.js?x=1"), Some(PathBuf::from("a/b c.js")));
        assert_eq!(inside("/"), Some(PathBuf::new()));
        for outside in [
            "/../secret",
            "/a/../../secret",
            "/%2e%2e/secret",
            "//etc/passwd",
            "relative",
            "/%zz",
            "/%e",
        ] {
            assert_eq!(inside(outside), None, "{outside}");
        }
    }

    #[test]
    fn a_file_is_served_with_its_type_and_a_missing_one_is_not_found() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        let address = in_background(folder).unwrap();
        let ask = |request: &str| {
            let mut stream = TcpStream::connect(address).unwrap();
            stream.write_all(request.as_bytes()).unwrap();
            let mut answer = String::new();
            stream.read_to_string(&mut answer).unwrap();
            answer
        };
        let found = ask("GET /Cargo.toml HTTP/1.1\r\nHost: x\r\n\r\n");
        assert!(
            found.starts_with("HTTP/1.1 200 OK\r\nContent-Type: text/plain"),
            "{found}"
        );
        assert!(found.ends_with(&fs::read_to_string(folder.join("Cargo.toml")).unwrap()));
        assert!(ask("GET /none HTTP/1.1\r\n\r\n").starts_with("HTTP/1.1 404 "));
        let head = ask("HEAD /Cargo.toml HTTP/1.1\r\n\r\n");
        assert!(
            head.ends_with("\r\n\r\n") && found.starts_with(&head),
            "{head}"
        );
        assert!(ask("POST / HTTP/1.1\r\n\r\n").starts_with("HTTP/1.1 405 "));
    }
}
