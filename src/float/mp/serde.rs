//! Numbers are serialised as decimal text with all digits, and read from such text. A number of the data
//! format would pass through `f64`.

use super::Mp;
use core::fmt::{self, Formatter};
use serde::de::{Deserialize, Deserializer, Error, Visitor};
use serde::ser::{Serialize, Serializer};

impl<const LIMBS: usize> Serialize for Mp<LIMBS> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, const LIMBS: usize> Deserialize<'de> for Mp<LIMBS> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text<const LIMBS: usize>;

        impl<const LIMBS: usize> Visitor<'_> for Text<LIMBS> {
            type Value = Mp<LIMBS>;

            fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
                f.write_str("a decimal number as text")
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
                text.parse().map_err(E::custom)
            }
        }

        deserializer.deserialize_str(Text)
    }
}
