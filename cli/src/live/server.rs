//! The server: one thread for all tabs, separate from the rendering.

use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::time::Duration;

use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::{TcpListener as Listener, TcpStream};
use tokio::runtime;
use tokio::sync::oneshot;

use super::answer::answer;
use super::board::Board;
use super::page::Page;

/// The longest wait for a request's header.
const PATIENCE: Duration = Duration::from_secs(10);

/// Pause after an error, such as too many open files.
const PAUSE: Duration = Duration::from_millis(100);

/// Listens on this machine's own address 127.0.0.1, which is unreachable from outside; at a free port for 0.
///
/// # Errors
/// A port that is taken or not permitted.
pub fn listen(port: u16) -> io::Result<TcpListener> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port))
}

/// A server that ends when it is dropped.
#[derive(Debug)]
pub struct Server {
    _end: oneshot::Sender<Infallible>,
}

impl Server {
    /// Serves from now on.
    ///
    /// # Errors
    /// Threads or files that the system refuses.
    pub fn start(listener: TcpListener, board: Arc<Board>) -> io::Result<Self> {
        let port = listener.local_addr()?.port();
        let page = Arc::new(Page::new(&board.title)?);
        listener.set_nonblocking(true)?;
        let runtime = runtime::Builder::new_current_thread()
            .enable_all()
            .build()?;
        let listener = {
            let _inside = runtime.enter();
            Listener::from_std(listener)?
        };
        let (end, ended) = oneshot::channel();
        std::thread::Builder::new()
            .name("view".to_owned())
            .spawn(move || {
                runtime.spawn(accept(listener, port, board, page));
                // Nobody sends: this waits for the sender to be dropped.
                let _ = runtime.block_on(ended);
            })?;
        Ok(Self { _end: end })
    }
}

/// Accepts connections forever.
async fn accept(listener: Listener, port: u16, board: Arc<Board>, page: Arc<Page>) {
    loop {
        match listener.accept().await {
            Ok((stream, _)) => drop(tokio::spawn(talk(
                stream,
                port,
                board.clone(),
                page.clone(),
            ))),
            Err(_) => tokio::time::sleep(PAUSE).await,
        }
    }
}

/// Answers all requests of one connection.
async fn talk(stream: TcpStream, port: u16, board: Arc<Board>, page: Arc<Page>) {
    let service = service_fn(|request| {
        let answer = answer(&request, port, &board, &page);
        async { Ok::<_, Infallible>(answer) }
    });
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new()).header_read_timeout(PATIENCE);
    // An error of a connection concerns only its tab, which asks again.
    let _ = http.serve_connection(TokioIo::new(stream), service).await;
}
