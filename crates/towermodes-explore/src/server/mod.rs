//! The server of the page: only for this machine, and only with the token in the address.
//!
//! Other pages in the browser can neither read the page nor send requests: the address has 128
//! random bits, the headers `Host`, `Origin` and `Sec-Fetch-Site` must be those of the page itself
//! (which also refuses DNS rebinding to this machine), and the answers allow only the scripts of
//! the page.

mod gate;
mod reply;
mod route;

use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Request, Response};
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::TcpStream;
use tokio::runtime::{Builder, Runtime};

use super::explorer::Explorer;
use gate::Gate;
use route::Routes;

/// A connection without a request for this time is closed. The browser then opens a new one.
const IDLE: Duration = Duration::from_secs(5);
/// A request body that takes longer than this is refused.
const SLOW_BODY: Duration = Duration::from_secs(10);
/// Further connections are closed at once. A browser uses six.
const MOST_CONNECTIONS: usize = 256;
/// The largest number of answers that are computed at the same time: besides the tower a page may
/// request the diagram of a turbine, its modes at a rotor speed, and a design.
const THREADS: usize = 4;

/// A server with an open port that does not yet answer.
pub struct Server {
    listener: TcpListener,
    runtime: Runtime,
    gate: Gate,
}

impl Server {
    /// Opens a server on a port of this machine; 0 selects any free port.
    ///
    /// # Errors
    /// The error of the system: the port is taken, or may not be used.
    pub fn bind(port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port)))?;
        listener.set_nonblocking(true)?;
        let gate = Gate::new(listener.local_addr()?.port(), token()?);
        let runtime = Builder::new_current_thread()
            .enable_all()
            .max_blocking_threads(THREADS)
            .build()?;
        Ok(Self {
            listener,
            runtime,
            gate,
        })
    }

    /// The address of the page: `http://127.0.0.1:PORT/TOKEN/`.
    pub fn address(&self) -> String {
        self.gate.address()
    }

    /// Serves the page until the program ends.
    ///
    /// # Errors
    /// The error of the system if the server cannot listen.
    pub fn run(self, explorer: Explorer) -> io::Result<()> {
        let Self {
            listener,
            runtime,
            gate,
        } = self;
        let routes = Arc::new(Routes::new(explorer, gate));
        runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener)?;
            let open = Arc::new(AtomicUsize::new(0));
            loop {
                match listener.accept().await {
                    Ok((stream, _)) => admit(stream, &open, &routes),
                    // No more files may be open, or the other side has gone: others go on.
                    Err(_) => tokio::time::sleep(Duration::from_millis(50)).await,
                }
            }
        })
    }
}

/// 128 random bits.
fn token() -> io::Result<String> {
    let mut bits = [0; 16];
    getrandom::fill(&mut bits).map_err(io::Error::other)?;
    Ok(bits.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Serves a connection, or closes it if there are too many.
fn admit(stream: TcpStream, open: &Arc<AtomicUsize>, routes: &Arc<Routes>) {
    if open.load(Ordering::Relaxed) >= MOST_CONNECTIONS {
        return;
    }
    open.fetch_add(1, Ordering::Relaxed);
    let (open, routes) = (Arc::clone(open), Arc::clone(routes));
    tokio::spawn(async move {
        // An answer is two small writes; without this the second waits for the other side.
        let _ = stream.set_nodelay(true);
        let service = service_fn(|request| answered(request, Arc::clone(&routes)));
        // Whoever breaks the connection gets no answer, and nobody else is concerned.
        let _ = http1::Builder::new()
            .timer(TokioTimer::new())
            .header_read_timeout(IDLE)
            .serve_connection(TokioIo::new(stream), service)
            .await;
        open.fetch_sub(1, Ordering::Relaxed);
    });
}

async fn answered(
    request: Request<Incoming>,
    routes: Arc<Routes>,
) -> Result<Response<reply::Body>, std::convert::Infallible> {
    let (head, body) = request.into_parts();
    Ok(match routes.find(&head) {
        Err(refused) => reply::refused(refused),
        Ok(route) => route::answer(routes, route, body).await,
    })
}
