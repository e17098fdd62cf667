//! Paths and what they answer.

use std::convert::Infallible;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use axum::Router;
use axum::body::Bytes;
use axum::extract::{DefaultBodyLimit, Query, Request, State};
use axum::http::{StatusCode, Uri, header};
use axum::middleware::{self, Next};
use axum::response::sse::{Event, Sse};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use futures_util::stream::{self, Stream};
use serde::Deserialize;
use tokio::sync::broadcast;
use wirebend_api::Workspace;

/// The largest file that is handed over.
const MAX_BYTES: usize = 512 << 20;

pub(crate) struct Served {
    pub desk: Arc<Workspace>,
    pub events: broadcast::Sender<String>,
    pub token: Box<str>,
    pub dist: PathBuf,
    pub files: PathBuf,
}

#[derive(Deserialize)]
struct Named {
    #[serde(default)]
    name: String,
    #[serde(default)]
    token: String,
}

pub(crate) fn router(served: Arc<Served>) -> Router {
    let asked = Router::new()
        .route("/ask", post(ask))
        .route("/stencil", post(stencil))
        .route("/upload", post(upload))
        .route("/save-path", post(save_path))
        .route("/stop", post(stop))
        .route("/events", get(events))
        .layer(DefaultBodyLimit::max(MAX_BYTES))
        .layer(middleware::from_fn_with_state(Arc::clone(&served), with_token));
    asked.fallback(page).with_state(served)
}

/// Refuses whoever has not the token.
async fn with_token(
    State(served): State<Arc<Served>>,
    Query(named): Query<Named>,
    request: Request,
    next: Next,
) -> Response {
    let given =
        request.headers().get("x-token").and_then(|value| value.to_str().ok()).unwrap_or(&named.token);
    if *given == *served.token { next.run(request).await } else { StatusCode::FORBIDDEN.into_response() }
}

async fn ask(State(served): State<Arc<Served>>, body: String) -> Response {
    let answered = blocking(move || served.desk.ask_json(&body)).await;
    match answered {
        Ok(answer) => json(StatusCode::OK, answer.get().to_owned()),
        Err(refusal) => {
            json(StatusCode::UNPROCESSABLE_ENTITY, serde_json::to_string(&refusal).unwrap_or_default())
        }
    }
}

fn json(status: StatusCode, text: String) -> Response {
    (status, [(header::CONTENT_TYPE, "application/json")], text).into_response()
}

async fn stencil(State(served): State<Arc<Served>>, body: String) -> Response {
    let Ok(id) = body.parse() else { return StatusCode::BAD_REQUEST.into_response() };
    blocking(move || served.desk.stencil_mesh(id)).await.into_response()
}

async fn stop(State(served): State<Arc<Served>>) -> StatusCode {
    blocking(move || served.desk.stop()).await;
    StatusCode::NO_CONTENT
}

/// Keeps a file that a page hands over, and says where.
async fn upload(State(served): State<Arc<Served>>, Query(named): Query<Named>, body: Bytes) -> Response {
    let path = served.files.join(plain(&named.name));
    match std::fs::write(&path, &body) {
        Ok(()) => path.display().to_string().into_response(),
        Err(error) => (StatusCode::INTERNAL_SERVER_ERROR, error.to_string()).into_response(),
    }
}

async fn save_path(State(served): State<Arc<Served>>, Query(named): Query<Named>) -> String {
    served.files.join(plain(&named.name)).display().to_string()
}

/// A name without folders.
fn plain(name: &str) -> &str {
    Path::new(name).file_name().and_then(|name| name.to_str()).unwrap_or("file")
}

async fn events(State(served): State<Arc<Served>>) -> Sse<impl Stream<Item = Result<Event, Infallible>>> {
    let heard = stream::unfold(served.events.subscribe(), |mut events| async {
        loop {
            match events.recv().await {
                Ok(text) => return Some((Ok(Event::default().data(text)), events)),
                // A page that was too slow hears the newer ones.
                Err(broadcast::error::RecvError::Lagged(_)) => {}
                Err(broadcast::error::RecvError::Closed) => return None,
            }
        }
    });
    Sse::new(heard)
}

/// A file of the built editor.
async fn page(State(served): State<Arc<Served>>, uri: Uri) -> Response {
    let asked = uri.path().trim_start_matches('/');
    let asked = Path::new(if asked.is_empty() { "index.html" } else { asked });
    if !asked.components().all(|part| matches!(part, Component::Normal(_))) {
        return StatusCode::NOT_FOUND.into_response();
    }
    let kind = match asked.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript",
        Some("css") => "text/css",
        Some("svg") => "image/svg+xml",
        _ => "application/octet-stream",
    };
    match std::fs::read(served.dist.join(asked)) {
        Ok(bytes) => ([(header::CONTENT_TYPE, kind)], bytes).into_response(),
        Err(_) => StatusCode::NOT_FOUND.into_response(),
    }
}

/// Runs what may take long where it holds nobody up.
async fn blocking<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> T {
    tokio::task::spawn_blocking(work)
        .await
        .unwrap_or_else(|error| std::panic::resume_unwind(error.into_panic()))
}
