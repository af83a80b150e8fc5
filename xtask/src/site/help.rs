//! The guide and the references of docs/ as pages of the site, under `help/`, so that they are there offline too.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

use crate::shell::{self, Result, read};

/// The folder of the pages on the site; it has the stylesheet already.
const FOLDER: &str = "help";
/// The folder of the guide's pictures, beside its pages both in docs/ and on the site.
const PICTURES: &str = "pictures";
/// The guide's contents, and what it is called on the site. Hosts redirect the name `index.html`, and browsers refuse
/// redirected copies offline.
const CONTENTS: &str = "docs/guide/README.md";
const CONTENTS_PAGE: &str = "guide.html";

/// The only HTML in texts: names of keys.
const KEY_TAGS: [&str; 2] = ["<kbd>", "</kbd>"];

/// A page to make.
struct Page {
    /// The file, from the project's folder.
    source: String,
    /// Its name on the site.
    name: String,
    text: String,
}

/// Writes the pages into a site.
pub fn write(root: &Path, site: &Path) -> Result {
    let pages = pages(root)?;
    let folder = site.join(FOLDER);
    for page in &pages {
        shell::write(&folder.join(&page.name), &render(page, &pages, root)?)?;
    }
    shell::make_folder(&folder.join(PICTURES))?;
    for picture in shell::entries(&root.join("docs/guide").join(PICTURES)) {
        let name = picture.file_name().unwrap_or_default();
        shell::copy(&picture, &folder.join(PICTURES).join(name))?;
    }
    Ok(())
}

/// The texts: those of the guide in the order of its contents, then all others.
fn pages(root: &Path) -> Result<Vec<Page>> {
    let mut pages = Vec::new();
    for folder in ["docs/guide", "docs"] {
        for path in shell::entries(&root.join(folder)) {
            let Some(stem) = path.file_name().and_then(|name| name.to_str()?.strip_suffix(".md")) else {
                continue;
            };
            let source = format!("{folder}/{stem}.md");
            let name = if source == CONTENTS { CONTENTS_PAGE.to_owned() } else { format!("{stem}.html") };
            if pages.iter().any(|page: &Page| page.name == name) {
                return Err(format!("{source} would have the name of another page of the help, {name}."));
            }
            pages.push(Page { source, name, text: read(&path)? });
        }
    }
    let contents = read(&root.join(CONTENTS))?;
    // Where a page is first named in the contents; its own beginning is the contents themselves.
    let place = |page: &Page| {
        let link = format!("]({})", page.source.strip_prefix("docs/guide/").unwrap_or(&page.source));
        if page.name == CONTENTS_PAGE { Some(0) } else { contents.find(&link) }
    };
    pages.sort_by_key(|page| place(page).unwrap_or(usize::MAX));
    Ok(pages)
}

/// The events of a text, with anchors at its headings.
fn parse(page: &Page) -> Result<Vec<Event<'_>>> {
    let mut events: Vec<Event<'_>> =
        Parser::new_ext(&page.text, Options::ENABLE_TABLES).filter(|event| !is_comment(event)).collect();
    let mut anchors = BTreeMap::new();
    for at in 0..events.len() {
        let words = heading_at(&events, at);
        match events.get_mut(at) {
            Some(Event::Start(Tag::Heading { id, .. })) => *id = Some(anchor(&words, &mut anchors).into()),
            Some(Event::InlineHtml(tag) | Event::Html(tag)) if !KEY_TAGS.contains(&&**tag) => {
                return Err(format!("{} has HTML that the help doesn't take: {tag}", page.source));
            }
            _ => {}
        }
    }
    Ok(events)
}

fn is_comment(event: &Event<'_>) -> bool {
    let is_mark = |html: &str| html.starts_with("<!--") || html.trim().is_empty();
    matches!(event, Event::Html(html) if is_mark(html))
        || matches!(event, Event::Start(Tag::HtmlBlock) | Event::End(TagEnd::HtmlBlock))
}

/// The words of the heading that begins here.
fn heading_at(events: &[Event<'_>], at: usize) -> String {
    let mut words = String::new();
    for event in events.iter().skip(at) {
        match event {
            Event::Text(text) | Event::Code(text) => words.push_str(text),
            Event::End(TagEnd::Heading(_)) => break,
            _ => {}
        }
    }
    words
}

/// The anchor of a heading, as GitHub makes it, so that the same links work there.
fn anchor(words: &str, used: &mut BTreeMap<String, usize>) -> String {
    let kept = words.to_lowercase().replace(' ', "-");
    let anchor: String = kept.chars().filter(|c| c.is_alphanumeric() || "-_".contains(*c)).collect();
    let count = used.entry(anchor.clone()).or_default();
    *count += 1;
    if *count == 1 { anchor } else { format!("{anchor}-{}", *count - 1) }
}

/// A text as a page.
fn render(page: &Page, pages: &[Page], root: &Path) -> Result<String> {
    let mut events = parse(page)?;
    let mut title = None;
    for at in 0..events.len() {
        if title.is_none() && matches!(events.get(at), Some(Event::Start(Tag::Heading { .. }))) {
            title = Some(heading_at(&events, at));
        }
        match events.get_mut(at) {
            Some(Event::Start(Tag::Link { dest_url, .. })) => *dest_url = link(page, dest_url, pages)?.into(),
            Some(Event::Start(Tag::Image { dest_url, .. })) => {
                let to = file_of(page, dest_url)?;
                let in_pictures = Path::new(&to).parent() == Some(&Path::new("docs/guide").join(PICTURES));
                if !in_pictures || !root.join(&to).is_file() {
                    return Err(format!("{} shows {to}, which is no picture of the guide.", page.source));
                }
                let name = to.rsplit('/').next().unwrap_or_default();
                *dest_url = format!("{PICTURES}/{name}").into();
            }
            _ => {}
        }
    }
    // Wide tables scroll by themselves.
    let mark = |html| Event::Html(CowStr::Borrowed(html));
    let framed = events.into_iter().flat_map(|event| {
        let start = matches!(event, Event::Start(Tag::Table(_))).then(|| mark("<div class=\"table\">"));
        let end = matches!(event, Event::End(TagEnd::Table)).then(|| mark("</div>"));
        start.into_iter().chain([event]).chain(end)
    });
    let mut body = String::new();
    html::push_html(&mut body, framed);
    let title = title.ok_or_else(|| format!("{} has no heading.", page.source))?;
    Ok(frame(&title, &body, &neighbours(page, pages)?))
}

/// The pages of the guide before and after this one, as links.
fn neighbours(page: &Page, pages: &[Page]) -> Result<String> {
    let guide: Vec<&Page> = pages.iter().filter(|page| page.source.starts_with("docs/guide/")).collect();
    let Some(at) = guide.iter().position(|other| other.name == page.name) else { return Ok(String::new()) };
    let mut links = String::new();
    for (other, words) in [(at.checked_sub(1), "Back"), (Some(at + 1), "Next")] {
        let Some(other) = other.and_then(|at| guide.get(at)) else { continue };
        let events = parse(other)?;
        let title = escape(&heading_at(&events, 0));
        links += &format!("<a href=\"{}\">{words}: {title}</a>\n", other.name);
    }
    Ok(links)
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn frame(title: &str, body: &str, neighbours: &str) -> String {
    let title = escape(title);
    let footer =
        if neighbours.is_empty() { String::new() } else { format!("<footer>\n{neighbours}</footer>\n") };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title} – Meshwright</title>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'self'; img-src 'self'; \
         base-uri 'none'; form-action 'none'\">\n\
         <link rel=\"icon\" type=\"image/svg+xml\" href=\"../icon.svg\">\n<link rel=\"stylesheet\" href=\"help.css\">\n\
         </head>\n<body>\n<header>\n<a href=\"../\">Meshwright</a>\n<a href=\"{CONTENTS_PAGE}\">Guide</a>\n\
         <a href=\"keys.html\">Keys</a>\n<a href=\"operations.html\">Operations</a>\n\
         <a href=\"glossary.html\">Glossary</a>\n</header>\n<main>\n{body}</main>\n{footer}</body>\n</html>\n"
    )
}

/// Where a link of a text leads on the site.
fn link(page: &Page, to: &str, pages: &[Page]) -> Result<String> {
    if to.starts_with("https://") {
        return Ok(to.to_owned());
    }
    let (file, fragment) = to.split_once('#').map_or((to, None), |(file, fragment)| (file, Some(fragment)));
    let file = if file.is_empty() { page.source.clone() } else { file_of(page, file)? };
    let Some(target) = pages.iter().find(|other| other.source == file) else {
        return Err(format!("{} has a link to {file}, which is no page of the help.", page.source));
    };
    let Some(fragment) = fragment else { return Ok(target.name.clone()) };
    let is_here = |event: &Event<'_>| matches!(event, Event::Start(Tag::Heading { id: Some(id), .. }) if **id == *fragment);
    if !parse(target)?.iter().any(is_here) {
        return Err(format!(
            "{} has a link to {file}#{fragment}, where there is no such heading.",
            page.source
        ));
    }
    Ok(format!("{}#{fragment}", target.name))
}

/// The file that a link names, from the project's folder.
fn file_of(page: &Page, to: &str) -> Result<String> {
    let mut path = PathBuf::from(&page.source);
    path.pop();
    for part in Path::new(to).components() {
        match part {
            Component::ParentDir if path.pop() => {}
            Component::Normal(name) => path.push(name),
            Component::CurDir => {}
            _ => return Err(format!("{} has a link that leads nowhere: {to}", page.source)),
        }
    }
    let names: Vec<_> = path.iter().map(|name| name.to_string_lossy()).collect();
    Ok(names.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::project::Project;
    use std::fs;

    fn page(source: &str, name: &str, text: &str) -> Page {
        Page { source: source.to_owned(), name: name.to_owned(), text: text.to_owned() }
    }

    fn two(first: &str) -> Result<String> {
        let pages = [
            page("docs/guide/a.md", "a.html", first),
            page("docs/b.md", "b.html", "# B\n\n## A part, *with* `code`\n\n## Twice\n\n## Twice\n"),
        ];
        render(&pages[0], &pages, Path::new("nowhere"))
    }

    #[test]
    fn links_lead_to_pages_and_headings_that_exist() {
        let made = two(
            "# A & A\n\n[b](../b.md), [part](../b.md#a-part-with-code), [two](../b.md#twice-1), [up](#a--a)\n",
        );
        let made = made.expect("made");
        for href in ["b.html", "b.html#a-part-with-code", "b.html#twice-1", "a.html#a--a"] {
            assert!(made.contains(&format!("<a href=\"{href}\">")), "{href} in {made}");
        }
        assert!(made.contains("<title>A &amp; A – Meshwright</title>"), "{made}");
        for (link, error) in [
            ("../c.md", "docs/c.md, which is no page"),
            ("../b.md#nothing", "docs/b.md#nothing, where there is no such heading"),
            ("../../../b.md", "leads nowhere"),
            ("http://example.org", "no page"),
        ] {
            let refused = two(&format!("# A\n\n[x]({link})\n")).expect_err(link);
            assert!(refused.contains("docs/guide/a.md") && refused.contains(error), "{refused}");
        }
        assert!(
            two("# A\n\n![x](pictures/none.png)\n").expect_err("no picture").contains("pictures/none.png")
        );
    }

    #[test]
    fn keys_are_the_only_html_and_comments_are_left_out() {
        let made =
            two("# A\n\n<!-- made by hand -->\n\n<kbd>G</kbd> moves\n\n| a |\n|---|\n| b |\n").expect("made");
        assert!(made.contains("<kbd>G</kbd> moves") && !made.contains("by hand"), "{made}");
        assert!(made.contains("<div class=\"table\"><table>") && made.contains("</table>\n</div>"), "{made}");
        for text in ["<b>x</b>", "<script>alert(1)</script>\n"] {
            assert!(two(&format!("# A\n\n{text}\n")).expect_err("HTML").contains("HTML"));
        }
    }

    #[test]
    fn the_help_is_complete() {
        let root = Project::find().expect("a project").root;
        let site = std::env::temp_dir().join(format!("meshwright-help-{}", std::process::id()));
        let _ = fs::remove_dir_all(&site);
        fs::create_dir_all(site.join(FOLDER)).expect("a folder");
        write(&root, &site).expect("every link of the help leads somewhere");
        let made: BTreeMap<String, String> = shell::entries(&site.join(FOLDER))
            .iter()
            .filter(|path| path.is_file())
            .map(|path| {
                (path.file_name().expect("a name").to_string_lossy().into_owned(), read(path).expect("text"))
            })
            .collect();
        // Every page is reached from the contents, and every picture is shown.
        let contents = &made[CONTENTS_PAGE];
        for name in made.keys().filter(|name| *name != CONTENTS_PAGE) {
            assert!(contents.contains(&format!("\"{name}\"")), "the contents of the guide don't name {name}");
        }
        for picture in shell::entries(&site.join(FOLDER).join(PICTURES)) {
            let name = picture.file_name().expect("a name").to_string_lossy().into_owned();
            let shown = made.values().any(|page| page.contains(&format!("src=\"{PICTURES}/{name}\"")));
            assert!(shown, "no page shows {name}");
        }
        assert!(made.values().all(|page| !page.contains("alt=\"\"")), "each picture says what it shows");
        fs::remove_dir_all(&site).expect("removed");
    }

    #[test]
    fn the_links_of_the_readme_lead_to_files() {
        let root = Project::find().expect("a project").root;
        let readme = page("README.md", "", &read(&root.join("README.md")).expect("text"));
        let mut links = 0;
        for event in Parser::new_ext(&readme.text, Options::ENABLE_TABLES) {
            let (Event::Start(Tag::Link { dest_url, .. }) | Event::Start(Tag::Image { dest_url, .. })) =
                event
            else {
                continue;
            };
            if dest_url.starts_with("http") {
                continue;
            }
            let file = file_of(&readme, dest_url.split('#').next().unwrap_or_default()).expect("inside");
            assert!(root.join(&file).exists(), "README.md has a link to {file}, which isn't there");
            links += 1;
        }
        assert!(links > 5, "links are found");
    }
}
