//! Sends pictures to tev, a viewer of linear pictures, from a thread of its own.

mod address;
mod packet;

use std::io::{self, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use super::snapshot::Snapshot;
pub use address::Address;

/// The timeout for a viewer, and the longest wait for it at the end.
const PATIENCE: Duration = Duration::from_secs(5);

/// A viewer, while it is reachable.
#[derive(Debug)]
pub struct Tev(Arc<Slot>);

/// The next picture: a newer one replaces one that was not yet sent.
#[derive(Debug, Default)]
struct Slot {
    next: Mutex<Next>,
    news: Condvar,
}

#[derive(Debug, Default)]
struct Next {
    snapshot: Option<Arc<Snapshot>>,
    /// Nothing follows it.
    is_last: bool,
    /// Nothing is sent any more.
    has_ended: bool,
}

impl Tev {
    /// Sends pictures under that name. On failure, `complain` gets the reason, and nothing more is sent.
    ///
    /// # Errors
    /// A thread that the system refuses.
    pub fn start(
        address: Address,
        name: String,
        complain: impl FnOnce(&str) + Send + 'static,
    ) -> io::Result<Self> {
        let slot = Arc::new(Slot::default());
        let own = slot.clone();
        thread::Builder::new()
            .name("tev".to_owned())
            .spawn(move || {
                if let Err(error) = send(&own, &address, &name) {
                    complain(&format!(
                        "cannot send pictures to tev at {address}: {error}; the rendering continues"
                    ));
                }
                own.next().has_ended = true;
                own.news.notify_all();
            })?;
        Ok(Self(slot))
    }

    /// Whether it has received everything so far.
    pub fn is_wanted(&self) -> bool {
        let next = self.0.next();
        next.snapshot.is_none() && !next.has_ended
    }

    /// Sends this next.
    pub fn show(&self, snapshot: Arc<Snapshot>) {
        self.0.next().snapshot = Some(snapshot);
        self.0.news.notify_all();
    }

    /// Waits briefly until the last picture is sent.
    pub fn finish(self) {
        let mut next = self.0.next();
        next.is_last = true;
        self.0.news.notify_all();
        // The program ends next, whatever the result.
        let waited = self
            .0
            .news
            .wait_timeout_while(next, PATIENCE, |next| !next.has_ended);
        drop(waited);
    }
}

impl Slot {
    fn next(&self) -> MutexGuard<'_, Next> {
        self.next.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for the next picture; `None` after the last.
    fn take(&self) -> Option<Arc<Snapshot>> {
        let is_idle = |next: &mut Next| next.snapshot.is_none() && !next.is_last;
        let next = self.news.wait_while(self.next(), is_idle);
        next.unwrap_or_else(PoisonError::into_inner).snapshot.take()
    }
}

/// Sends pictures until the last.
fn send(slot: &Slot, address: &Address, name: &str) -> io::Result<()> {
    let mut stream = connect(address)?;
    let mut is_open = false;
    while let Some(snapshot) = slot.take() {
        let film = &snapshot.film;
        if !is_open {
            // Closes the picture of an earlier rendering, which would be mistaken for this one's.
            stream.write_all(&packet::close(name))?;
            stream.write_all(&packet::create(name, film))?;
            is_open = true;
        }
        for update in packet::updates(name, film) {
            stream.write_all(&update)?;
        }
    }
    Ok(())
}

fn connect(address: &Address) -> io::Result<TcpStream> {
    let mut failure = io::ErrorKind::NotFound.into();
    for place in (address.host.as_str(), address.port).to_socket_addrs()? {
        match TcpStream::connect_timeout(&place, PATIENCE) {
            Ok(stream) => {
                stream.set_write_timeout(Some(PATIENCE))?;
                return Ok(stream);
            }
            Err(error) => failure = error,
        }
    }
    Err(failure)
}
