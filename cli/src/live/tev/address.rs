//! The address of tev.

use std::fmt;
use std::str::FromStr;

/// The port of tev unless its `--host` gives another.
const PORT: u16 = 14158;

/// A host and a port.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    pub host: String,
    pub port: u16,
}

impl FromStr for Address {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            "must be a host and an optional port, such as localhost or 192.168.0.7:14158".to_owned()
        };
        // An IPv6 address has colons of its own: [::1]:14158, [::1] or ::1.
        let (host, port) = match text.strip_prefix('[').map(|text| text.split_once(']')) {
            Some(None) => return Err(wrong()),
            Some(Some((host, ""))) => (host, None),
            Some(Some((host, rest))) => (host, Some(rest.strip_prefix(':').ok_or_else(wrong)?)),
            None => match text.split_once(':') {
                Some((host, port)) if !port.contains(':') => (host, Some(port)),
                _ => (text, None),
            },
        };
        let port = port
            .map_or(Ok(PORT), str::parse)
            .ok()
            .filter(|&port| port > 0);
        match port {
            Some(port) if !host.is_empty() && !host.contains(['/', ' ']) => Ok(Self {
                host: host.to_owned(),
                port,
            }),
            _ => Err(wrong()),
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.host.contains(':') {
            true => write!(f, "[{}]:{}", self.host, self.port),
            false => write!(f, "{}:{}", self.host, self.port),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn machines_and_ports() {
        let rows = [
            ("localhost", "localhost:14158"),
            ("10.0.0.7:99", "10.0.0.7:99"),
            ("::1", "[::1]:14158"),
            ("[::1]", "[::1]:14158"),
            ("[fe80::2]:99", "[fe80::2]:99"),
        ];
        for (text, expected) in rows {
            let address: Address = text.parse().expect(text);
            assert_eq!(address.to_string(), expected);
        }
        for wrong in [
            "", ":99", "a:", "a:0", "a:65536", "a:b", "[::1", "[::1]99", "http://a", "a b",
        ] {
            assert!(wrong.parse::<Address>().is_err(), "{wrong}");
        }
    }
}
