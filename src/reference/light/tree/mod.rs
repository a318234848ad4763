//! The tree of lights; twin of `shaders/light/tree/`.

pub mod descent;
pub mod importance;
pub mod tickets;

pub use crate::prepared::record::light_node::scalar::LightNode;
pub use descent::{TreeChoice, tree_choice, tree_pmf};
pub use importance::node_importance;
pub use tickets::{Tickets, all_tickets};
