//! What has changed in the profiles that a job was planned with.

use std::collections::BTreeSet;

use serde::Serialize;
use serde_json::Value;

use super::task::Task;

/// What a person reads of a profile, and no figure of the machine.
const FOR_PEOPLE: [&str; 4] = ["name", "description", "shapes", "export"];
/// Of more changed figures than this only their number is shown.
const NAMED: usize = 3;

impl Task<'_> {
    /// What to know before a wire is bent as it was planned, when the profiles have changed since. Nothing
    /// where the job was planned on another computer, with profiles that are not here.
    pub fn stale(&self) -> Vec<String> {
        let planned = &self.setup;
        let machine = self.app.setup(planned.machine_id(), Some(planned.material_id()));
        let Ok(now) = machine else { return Vec::new() };
        let pairs = [
            (planned.machine_id(), changed(&planned.machine.profile, &now.machine.profile)),
            (planned.material_id(), changed(&planned.material.profile, &now.material.profile)),
        ];
        let told = pairs.into_iter().filter(|(_, keys)| !keys.is_empty());
        told.map(|(id, keys)| {
            let mut what: Vec<_> = keys.iter().take(NAMED).cloned().collect();
            if keys.len() > NAMED {
                what.push(format!("{} more", keys.len() - NAMED));
            }
            format!(
                "the profile '{id}' has changed since the job was planned ({}): the wire is bent as it was planned; plan the job again to use the profile as it is now",
                what.join(", ")
            )
        })
        .collect()
    }
}

/// Dotted keys of the figures that are not the same.
fn changed<T: Serialize>(before: &T, now: &T) -> BTreeSet<String> {
    let value = |profile: &T| serde_json::to_value(profile).unwrap_or_default();
    let mut keys = BTreeSet::new();
    differ(&value(before), &value(now), "", &mut keys);
    keys
}

fn differ(before: &Value, now: &Value, key: &str, keys: &mut BTreeSet<String>) {
    // Where a figure is from does not change it.
    let (before, now) = (before.get("value").unwrap_or(before), now.get("value").unwrap_or(now));
    let (Value::Object(one), Value::Object(other)) = (before, now) else {
        if before != now {
            keys.insert(key.to_owned());
        }
        return;
    };
    let names: BTreeSet<_> = one.keys().chain(other.keys()).collect();
    for name in names {
        if key.is_empty() && FOR_PEOPLE.contains(&name.as_str()) {
            continue;
        }
        let inner = if key.is_empty() { name.clone() } else { format!("{key}.{name}") };
        let part = |all: &serde_json::Map<_, _>| all.get(name).cloned().unwrap_or_default();
        differ(&part(one), &part(other), &inner, keys);
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn figures_that_differ_are_named_and_nothing_else() {
        let before = json!({
            "name": "Kit", "limits": { "max_bend_deg": { "value": 155, "source": "a paper" }, "tail_mm": { "value": 400 } },
            "driver": { "settings": { "peg_time_ms": 60 } },
        });
        let now = json!({
            "name": "My kit", "limits": { "max_bend_deg": { "value": 150, "source": "a paper" }, "tail_mm": { "value": 400, "source": "me" } },
            "driver": { "settings": { "peg_time_ms": 60, "backlash_deg": 1 } },
        });
        let named: Vec<_> = changed(&before, &now).into_iter().collect();
        assert_eq!(named, ["driver.settings.backlash_deg", "limits.max_bend_deg"]);
        assert!(changed(&before, &before).is_empty());
    }
}
