//! The answers to requests.

use http_body_util::Full;
use hyper::body::Bytes;
use hyper::header::{self, HeaderName, HeaderValue};
use hyper::{Request, Response, StatusCode};

use super::board::Board;
use super::gate::{Route, admit};
use super::page::Page;
use super::snapshot::Pixels;

/// A complete answer.
pub type Answer = Response<Full<Bytes>>;

/// The number of a picture's snapshot.
const NUMBER: HeaderName = HeaderName::from_static("vkpt-number");

/// Answers a request to the server at `port`.
pub fn answer<B>(request: &Request<B>, port: u16, board: &Board, page: &Page) -> Answer {
    let admitted = admit(request.method(), request.uri(), request.headers(), port);
    let answer = match admitted {
        Ok(Route::Page) => of_type("text/html; charset=utf-8", page.html.clone()),
        Ok(Route::State(asked)) => match serde_json::to_vec(&board.answer(asked)) {
            Ok(json) => of_type("application/json", json.into()),
            Err(_) => refusal(StatusCode::INTERNAL_SERVER_ERROR),
        },
        Ok(Route::Picture) => picture(board),
        Ok(Route::Stop) => {
            board.stop();
            with_status(StatusCode::NO_CONTENT)
        }
        Err(status) => refusal(status),
    };
    guarded(answer, page)
}

/// The newest snapshot.
fn picture(board: &Board) -> Answer {
    let Some(snapshot) = board.snapshot() else {
        return refusal(StatusCode::NOT_FOUND);
    };
    let number = snapshot.number;
    let bytes = Bytes::from_owner(Pixels(snapshot));
    let mut answer = of_type("application/octet-stream", bytes);
    answer.headers_mut().insert(NUMBER, number.into());
    answer
}

fn with_status(status: StatusCode) -> Answer {
    let mut answer = Answer::default();
    *answer.status_mut() = status;
    answer
}

fn refusal(status: StatusCode) -> Answer {
    let mut answer = of_type("text/plain; charset=utf-8", format!("{status}\n").into());
    *answer.status_mut() = status;
    answer
}

fn of_type(kind: &'static str, body: Bytes) -> Answer {
    let mut answer = Response::new(Full::new(body));
    let kind = HeaderValue::from_static(kind);
    answer.headers_mut().insert(header::CONTENT_TYPE, kind);
    answer
}

/// Adds headers that keep other sites from reading or framing it, and the page from loading anything.
fn guarded(mut answer: Answer, page: &Page) -> Answer {
    let headers = answer.headers_mut();
    let rules = [
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::CACHE_CONTROL, "no-store"),
        (header::X_FRAME_OPTIONS, "DENY"),
        (header::REFERRER_POLICY, "no-referrer"),
        (
            HeaderName::from_static("cross-origin-resource-policy"),
            "same-origin",
        ),
        (
            HeaderName::from_static("cross-origin-opener-policy"),
            "same-origin",
        ),
    ];
    for (name, value) in rules {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.insert(header::CONTENT_SECURITY_POLICY, page.policy.clone());
    answer
}
