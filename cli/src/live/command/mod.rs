//! Starting the live view.

mod arguments;

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::live::{Address, Board, Server, Tev, Viewers, listen};
pub use arguments::LiveArguments;
use vkpt_lab::cli::exit::{Failure, note, warn};

/// The requested ways to view, checked to be available.
pub struct Doors {
    listener: Option<TcpListener>,
    tev: Option<Address>,
}

impl Doors {
    /// Binds the port, before anything is rendered.
    pub fn new(arguments: &LiveArguments) -> Result<Self, Failure> {
        let taken = |port| {
            listen(port).map_err(|error| {
                Failure::Usage(format!("--view: cannot listen on port {port}: {error}"))
            })
        };
        Ok(Self {
            listener: arguments.view.map(taken).transpose()?,
            tev: arguments.tev.clone(),
        })
    }

    /// Shows the rendering `title`, whose first pixel is `origin` of the full picture, and lets viewers set `stop`.
    pub fn open(
        self,
        title: &str,
        origin: [u32; 2],
        stop: &Arc<AtomicBool>,
    ) -> Result<Viewers, Failure> {
        let page = self.listener.map(|listener| {
            let port = listener.local_addr()?.port();
            let board = Arc::new(Board::new(title.to_owned(), stop.clone()));
            let server = Server::start(listener, board.clone())?;
            // Printed with --quiet, too: nobody could guess it.
            note(&format!("live view: http://127.0.0.1:{port}/"));
            Ok((board, server))
        });
        let tev = self
            .tev
            .map(|address| Tev::start(address, title.to_owned(), warn));
        let refused = |error: std::io::Error| Failure::Memory(error.to_string());
        let page = page.transpose().map_err(refused)?;
        Ok(Viewers::new(
            origin,
            page,
            tev.transpose().map_err(refused)?,
        ))
    }
}
