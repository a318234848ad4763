//! The same as JUnit XML, which CI services show (<https://github.com/testmoapp/junitxml>).

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesText, Event};

use super::{Case, Suite, Verdict};

/// One `testsuite` called `name`, with a `testcase` for each scene.
///
/// # Errors
/// Only those of `io`, for text in memory.
pub fn junit(suite: &Suite, name: &str) -> io::Result<String> {
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
    let seconds: f64 = suite.cases.iter().map(|case| case.seconds).sum();
    let of = |is: fn(&Verdict) -> bool| {
        let cases = suite.cases.iter().filter(|case| is(&case.verdict));
        cases.count().to_string()
    };
    let counts = [
        ("tests", suite.cases.len().to_string()),
        ("failures", of(|v| matches!(v, Verdict::Differs(_)))),
        ("errors", of(|v| matches!(v, Verdict::Failed(_)))),
        ("time", format!("{seconds:.3}")),
    ];
    let counts = counts.iter().map(|(name, value)| (*name, value.as_str()));
    let counts: Vec<(&str, &str)> = counts.collect();
    let all = writer
        .create_element("testsuites")
        .with_attributes(counts.clone());
    all.write_inner_content(|writer| {
        let one = writer
            .create_element("testsuite")
            .with_attribute(("name", name));
        one.with_attributes(counts).write_inner_content(|writer| {
            let each = |case| test_case(writer, case, name);
            suite.cases.iter().try_for_each(each)
        })?;
        Ok(())
    })?;
    let text = String::from_utf8(writer.into_inner()).map_err(io::Error::other)?;
    Ok(format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{text}\n"
    ))
}

fn test_case(writer: &mut Writer<Vec<u8>>, case: &Case, class: &str) -> io::Result<()> {
    let seconds = format!("{:.3}", case.seconds);
    let attributes = [
        ("name", &*case.name),
        ("classname", class),
        ("time", &*seconds),
    ];
    let element = writer
        .create_element("testcase")
        .with_attributes(attributes);
    let (tag, why) = match &case.verdict {
        Verdict::Differs(why) => ("failure", why),
        Verdict::Failed(why) => ("error", why),
        Verdict::Same | Verdict::Close { .. } | Verdict::Kept { .. } => {
            element.write_empty()?;
            return Ok(());
        }
    };
    element.write_inner_content(|writer| {
        let text = [std::slice::from_ref(why), &case.files[..]]
            .concat()
            .join("\n");
        let wrong = writer
            .create_element(tag)
            .with_attribute(("message", &**why));
        wrong
            .write_inner_content(|writer| writer.write_event(Event::Text(BytesText::new(&text))))?;
        Ok(())
    })?;
    Ok(())
}
