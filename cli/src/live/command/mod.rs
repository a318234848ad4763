//! Opening the doors to those who look on.

mod arguments;

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::live::{Address, Board, Onlookers, Server, Tev, listen};
pub use arguments::LiveArguments;
use vkpt_lab::cli::exit::{Failure, note, warn};

/// What is asked for, and can be had.
pub struct Doors {
    listener: Option<TcpListener>,
    tev: Option<Address>,
}

impl Doors {
    /// Takes the port, before anything is rendered.
    pub fn new(arguments: &LiveArguments) -> Result<Self, Failure> {
        let taken = |port| {
            listen(port).map_err(|error| {
                Failure::Usage(format!("--view: port {port} can't be had: {error}"))
            })
        };
        Ok(Self {
            listener: arguments.view.map(taken).transpose()?,
            tev: arguments.tev.clone(),
        })
    }

    /// Lets them look at the rendering `title`, whose first pixel is `origin` of the full picture, and set `stop`.
    pub fn open(
        self,
        title: &str,
        origin: [u32; 2],
        stop: &Arc<AtomicBool>,
    ) -> Result<Onlookers, Failure> {
        let page = self.listener.map(|listener| {
            let port = listener.local_addr()?.port();
            let board = Arc::new(Board::new(title.to_owned(), stop.clone()));
            let server = Server::start(listener, board.clone())?;
            // Told to the quiet too: nobody could guess it.
            note(&format!(
                "the picture as it grows: http://127.0.0.1:{port}/"
            ));
            Ok((board, server))
        });
        let tev = self
            .tev
            .map(|address| Tev::start(address, title.to_owned(), warn));
        let refused = |error: std::io::Error| Failure::Memory(error.to_string());
        let page = page.transpose().map_err(refused)?;
        Ok(Onlookers::new(
            origin,
            page,
            tev.transpose().map_err(refused)?,
        ))
    }
}
