//! The file on disk: what is read, what is kept aside, what is written and when.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use antipode_settings::{
    Action, Condition, Config, Input, Language, Lesson, Notice, Opened, Profile, Quality,
    config_path, open, read, write,
};

/// Longest wait for what the keeper's thread says.
const PATIENCE: Duration = Duration::from_secs(30);

fn place() -> (tempfile::TempDir, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("settings.ron");
    (dir, path)
}

fn opened(path: &Path) -> Opened {
    open(Some(path.to_owned()))
}

/// Opens a file of that text; what it came to, and the names beside it afterwards.
fn opened_with(text: impl AsRef<[u8]>) -> (Config, Vec<Notice>, Vec<String>) {
    let (dir, path) = place();
    fs::write(&path, text).unwrap();
    let Opened {
        config,
        notices,
        keeper,
    } = opened(&path);
    keeper.finish().unwrap();
    if !notices.is_empty() {
        assert_eq!(opened(&path).config, config, "what was rescued is written");
        assert_eq!(opened(&path).notices, [], "and is not told again");
    }
    let mut names: Vec<_> = fs::read_dir(dir.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    (config, notices, names)
}

fn said(notices: &[Notice]) -> String {
    let sentences: Vec<_> = notices.iter().map(Notice::to_string).collect();
    sentences.join("\n")
}

fn changed() -> Config {
    let mut config = Config::default();
    config.settings.field_of_view_deg = 90.0;
    config.settings.mouse_sensitivity_deg_per_px = 0.07;
    config.settings.quality = Quality::Exact;
    config.settings.language = Language::Polish;
    config.learnt = [Lesson::Dig, Lesson::Walk].into();
    "row(0.5 tabs(view*) 0.5 tabs(list parts*))".clone_into(&mut config.panes);
    config.taught_to_build = true;
    config.profiles.add("Left \"hand\", {()}").unwrap();
    let own = config.profiles.chosen_mut();
    own.bind(Action::Jump, Input::named("Mouse4").unwrap())
        .unwrap();
    for input in own.inputs(Action::Sink).to_vec() {
        own.unbind(Action::Sink, input).unwrap();
    }
    config
}

#[test]
fn without_a_file_defaults_hold_and_nothing_is_written() {
    let (dir, path) = place();
    let Opened {
        config,
        notices,
        keeper,
    } = opened(&path);
    assert_eq!((config, notices), (Config::default(), Vec::new()));
    keeper.finish().unwrap();
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn what_was_changed_is_there_next_time_and_the_directory_is_made() {
    let (dir, _) = place();
    let path = dir.path().join("a/b/settings.ron");
    let keeper = opened(&path).keeper;
    keeper.save(&Config::default());
    keeper.save(&changed());
    keeper.finish().unwrap();
    let again = opened(&path);
    assert_eq!((again.config, again.notices), (changed(), Vec::new()));
    assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn dropping_the_keeper_loses_no_change() {
    let (_dir, path) = place();
    let keeper = opened(&path).keeper;
    keeper.save(&changed());
    drop(keeper);
    assert_eq!(opened(&path).config, changed());
}

#[test]
fn a_change_is_written_without_waiting_for_the_end() {
    let (_dir, path) = place();
    let keeper = opened(&path).keeper;
    keeper.save(&changed());
    while !path.exists() {
        std::thread::yield_now();
    }
    assert_eq!(read(&fs::read(&path).unwrap()).config, changed());
    keeper.finish().unwrap();
}

#[test]
fn the_file_says_one_thing_a_line_in_words() {
    let text = write(&changed()).unwrap();
    for line in [
        "    schema: 1,",
        "        \"field-of-view\": 90.0,",
        "        \"view-distance\": 0,",
        "        \"quality\": \"exact\",",
        "        \"vsync\": true,",
        "            \"jump\": [\"Space\", \"pad-south\", \"Mouse4\"],",
        "            \"sink\": [],",
    ] {
        assert!(text.lines().any(|found| found == line), "{line}\n{text}");
    }
}

#[test]
fn a_bad_value_costs_only_its_field_and_is_told() {
    let text = write(&changed()).unwrap();
    let text = text.replace("\"field-of-view\": 90.0", "\"field-of-view\": 900.0");
    let text = text.replace("\"vsync\": true", "\"vsync\": \"perhaps\"");
    let text = text.replace("\"msaa\"", "\"mssa\"");
    let text = text.replace("\"pad-south\", \"Mouse4\"]", "\"pad-south\", \"Mouse9\"]");
    let (config, notices, names) = opened_with(&text);
    let mut expected = changed();
    expected.settings.reset("field-of-view");
    let own = expected.profiles.chosen_mut();
    own.unbind(Action::Jump, Input::named("Mouse4").unwrap())
        .unwrap();
    assert_eq!(config, expected);
    let said = said(&notices);
    for word in [
        "field-of-view",
        "900",
        "vsync",
        "perhaps",
        "mssa",
        "jump",
        "Mouse9",
    ] {
        assert!(said.contains(word), "{word} is not told: {said}");
    }
    assert_eq!(names, ["settings.ron", "settings.ron.odd-1"]);
}

#[test]
fn a_torn_file_is_kept_and_gives_what_can_be_read_of_it() {
    let whole = write(&changed()).unwrap();
    let torn = &whole[..whole.find("\"ui-scale\"").unwrap() + 12];
    let (config, notices, names) = opened_with(torn);
    let expected = Config {
        settings: changed().settings,
        ..Config::default()
    };
    assert_eq!(config, expected);
    assert!(
        matches!(&notices[..], [Notice::Damaged { .. }]),
        "{notices:?}"
    );
    assert_eq!(names, ["settings.ron", "settings.ron.damaged-1"]);
    let late = &whole[..whole.rfind("\"sink\"").unwrap()];
    let (config, ..) = opened_with(late);
    assert!(config.profiles.all().len() == 2);
    assert_eq!(config.profiles.chosen().inputs(Action::Jump).len(), 3);
}

#[test]
fn no_damage_is_ever_lost_or_written_over() {
    let (dir, path) = place();
    for damage in ["one", "two", ""] {
        fs::write(&path, damage).unwrap();
        let Opened {
            notices, keeper, ..
        } = opened(&path);
        assert!(said(&notices).contains("damaged"));
        keeper.finish().unwrap();
    }
    for (number, damage) in (1..).zip(["one", "two", ""]) {
        let kept = dir.path().join(format!("settings.ron.damaged-{number}"));
        assert_eq!(fs::read_to_string(kept).unwrap(), damage);
    }
}

#[test]
fn a_newer_file_is_kept_and_what_is_known_of_it_holds() {
    let text = write(&changed()).unwrap();
    let text = text.replace("schema: 1", "schema: 7");
    let text = text.replace("\"vsync\": true", "\"vsync\": true, \"smell\": 3");
    let (config, notices, names) = opened_with(&text);
    assert_eq!(config, changed());
    let said = said(&notices);
    assert!(said.contains("newer") && said.contains("smell"), "{said}");
    assert_eq!(names, ["settings.ron", "settings.ron.newer-1"]);
}

#[test]
fn an_older_file_is_brought_up_to_date_and_the_old_one_kept() {
    let by_hand = "(field_of_view: 100, quality: \"fast\", mouse_sensitivity: 0.2)";
    let (config, notices, names) = opened_with(by_hand);
    let mut expected = Config::default();
    expected.settings.field_of_view_deg = 100.0;
    expected.settings.quality = Quality::Fast;
    expected.settings.mouse_sensitivity_deg_per_px = 0.2;
    assert_eq!(config, expected);
    assert!(
        matches!(&notices[..], [Notice::Older { .. }]),
        "{notices:?}"
    );
    assert_eq!(names, ["settings.ron", "settings.ron.older-1"]);
}

#[test]
fn profiles_that_cannot_be_are_left_out_and_told() {
    let text = "(schema: 1, profile: \"B\", profiles: [
        (name: \"A\", keys: {\"jump\": [\"KeyJ\"], \"hop\": [\"KeyK\"], \"menu\": []}),
        (name: \"a\", keys: {}),
        (name: \"B\", keys: {\"jump\": [], \"use\": [\"Trigger\"], \"sink\": 3}, colour: 1),
    ])";
    let reading = read(text.as_bytes());
    assert_eq!(reading.condition, Condition::Sound);
    let profiles = &reading.config.profiles;
    let names: Vec<_> = profiles.all().iter().map(Profile::name).collect();
    assert_eq!((names, profiles.chosen_place()), (vec!["A", "B"], 1));
    assert_eq!(
        profiles.all()[0].inputs(Action::Menu),
        [Input::key("Escape").unwrap()]
    );
    assert!(profiles.chosen().inputs(Action::Jump).is_empty());
    for action in [Action::Use, Action::Sink] {
        assert!(
            profiles.chosen().is_default(action),
            "{action:?} keeps a key"
        );
    }
    let said = said(&reading.notices);
    for word in [
        "hop",
        "\"a\" is left out",
        "Trigger",
        "sink is bound to 3",
        "colour",
    ] {
        assert!(said.contains(word), "{word} is not told: {said}");
    }
}

#[test]
fn what_is_no_file_is_told_and_left_alone() {
    let (_dir, path) = place();
    fs::create_dir(&path).unwrap();
    let Opened {
        config,
        notices,
        keeper,
    } = opened(&path);
    assert_eq!(config, Config::default());
    assert!(
        matches!(&notices[..], [Notice::Unreadable { .. }]),
        "{notices:?}"
    );
    assert!(!keeper.is_active());
    keeper.save(&changed());
    keeper.finish().unwrap();
    assert!(path.is_dir());
}

#[test]
fn a_place_that_takes_no_file_is_told_once_and_the_game_goes_on() {
    let (dir, path) = place();
    fs::write(&path, "in the way").unwrap();
    let below = path.join("settings.ron");
    let opened = opened(&below);
    assert!(matches!(
        &opened.notices[..],
        [] | [Notice::Unreadable { .. }]
    ));
    let fresh = dir.path().join("fresh").join("settings.ron");
    let keeper = open(Some(fresh.clone())).keeper;
    fs::write(dir.path().join("fresh"), "in the way").unwrap();
    keeper.save(&changed());
    let began = Instant::now();
    let problem = loop {
        if let Some(problem) = keeper.take_problem() {
            break problem;
        }
        assert!(began.elapsed() < PATIENCE, "the failure was never told");
        std::thread::sleep(Duration::from_millis(1));
    };
    assert!(problem.to_string().contains("settings.ron"), "{problem}");
    keeper.save(&changed());
    assert!(keeper.finish().is_err(), "the last change is not on disk");
}

#[test]
fn a_file_marked_as_read_only_is_neither_replaced_nor_put_aside() {
    for text in [write(&changed()).unwrap(), "damage".to_owned()] {
        let (dir, path) = place();
        fs::write(&path, &text).unwrap();
        let mut marked = fs::metadata(&path).unwrap().permissions();
        marked.set_readonly(true);
        fs::set_permissions(&path, marked).unwrap();
        let Opened {
            notices, keeper, ..
        } = opened(&path);
        keeper.save(&Config::default());
        let saved = keeper.finish();
        let told = said(&notices) + &saved.err().map_or_else(String::new, |e| e.to_string());
        assert!(told.contains("read-only"), "{told}");
        assert_eq!(fs::read_to_string(&path).unwrap(), text);
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }
}

#[test]
fn a_file_far_too_long_is_damaged_and_not_read_as_a_whole() {
    let text = write(&changed()).unwrap() + &" ".repeat(1 << 20);
    let (config, notices, _) = opened_with(text);
    assert_eq!(config, Config::default());
    assert!(matches!(&notices[..], [Notice::Damaged { .. }]));
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link() {
    let (dir, path) = place();
    let target = dir.path().join("elsewhere.ron");
    fs::write(&target, write(&Config::default()).unwrap()).unwrap();
    std::os::unix::fs::symlink(&target, &path).unwrap();
    let keeper = opened(&path).keeper;
    keeper.save(&changed());
    keeper.finish().unwrap();
    assert!(fs::symlink_metadata(&path).unwrap().is_symlink());
    assert_eq!(opened(&target).config, changed());
}

#[test]
fn the_command_line_chooses_the_file() {
    let given = Path::new("here.ron");
    assert_eq!(config_path(Some(given)), Some(given.to_owned()));
    let platform = config_path(None);
    assert!(platform.is_none_or(|path| path.ends_with("settings.ron")));
}

#[test]
fn without_a_place_the_game_is_told_and_goes_on() {
    let Opened {
        config,
        notices,
        keeper,
    } = open(None);
    assert_eq!(
        (config, notices),
        (Config::default(), vec![Notice::NoPlace])
    );
    keeper.save(&changed());
    keeper.finish().unwrap();
}
