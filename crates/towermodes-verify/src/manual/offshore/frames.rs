//! Frames without a tower: with free top by SubDyn's element and as exact beams, and with fixed
//! top.

use towermodes::frame::{FrameDescription, FrameRecipe, JointKind};

use super::case;
use super::moorings::stiffness;
use crate::case::Case;
use crate::expected::{Expected, Quantity};
use crate::subject::Subject;
use crate::towers::offshore::{
    bent, guyed, iea_15_monopile, jacket, jointed, oc3_monopile, tube_on_soil, with_body,
    with_heavy_links, with_spring, with_top_held,
};

/// Elements of the public frames.
const EXACT: FrameRecipe = FrameRecipe::Spectral { degree: 8 };
/// Tolerance for ten digits of the source, of which nodal coordinates lose some.
const DIGITS: f64 = 3e-10;
/// Tolerance for mechanisms: motions without stiffness reduce the accuracy of the source by two
/// digits.
const DIGITS_OF_MECHANISMS: f64 = 1e-8;

pub(super) fn cases() -> Vec<Case> {
    let mut cases = on_soil();
    cases.extend(with_joints());
    cases.extend(with_other_members());
    cases.extend(public());
    cases.extend(reduced());
    cases
}

const ABOVE: &str = "Differing digits are omitted: both programs compute Ritz values, which are above the exact values, and those of this program are lower.";

/// A frame with its expected values as text; an empty text means no values.
struct Values {
    mass_kg: &'static str,
    /// By SubDyn's element with four parts per member, with free top.
    subdyn: &'static str,
    /// As exact beams, with free top.
    exact: &'static str,
    /// As exact beams, with fixed top.
    held: &'static str,
}

/// The cases of a frame whose top is the joint with this index, from 0.
fn cases_of(name: &str, frame: &FrameDescription, top: usize, values: &Values) -> Vec<Case> {
    let subdyn = Some(FrameRecipe::Subdyn { divisions: 4 });
    let of = |what: &str, frame: FrameDescription, recipe, expected| {
        let subject = Subject::Frame(Box::new(frame), recipe);
        case(format!("{name}{what}"), "", subject, expected, DIGITS)
    };
    let mut exact = Expected::lowest(values.exact);
    if !values.mass_kg.is_empty() {
        exact.push(Expected::parsed(Quantity::Mass, values.mass_kg));
    }
    let held = with_top_held(frame.clone(), top);
    let mut cases = vec![
        of("", frame.clone(), subdyn, Expected::lowest(values.subdyn)),
        of("", frame.clone(), None, exact),
        of(", top held", held, None, Expected::lowest(values.held)),
    ];
    cases.retain(|case| !case.expected.is_empty());
    cases
}

fn on_soil() -> Vec<Case> {
    let held_at_base = [true; 6];
    let in_part = [true, true, true, false, false, true];
    let mut cases = cases_of(
        "tube on soil",
        &tube_on_soil([false; 6], 1.0),
        1,
        &Values {
            mass_kg: "33149.895755",
            subdyn: "1.3918582502 1.4394188667 10.654205749 11.0076187899 13.9015389621",
            exact: "1.3918473771 1.4394072265 10.6489535376 11.0016783227 13.8977693564",
            held: "11.0354006883 11.383731541 27.33713141 27.4080314754",
        },
    );
    cases.extend(cases_of(
        "tube on soil, translations and torsion fixed",
        &tube_on_soil(in_part, 1.0),
        1,
        &Values {
            mass_kg: "33149.895755",
            subdyn: "2.5128594311 2.5483435727 22.3695003947 22.411041046",
            exact: "2.5128244018 2.5483070546 22.3508201602 22.3922658448",
            held: "21.758561502 21.8033866676 59.82969",
        },
    ));
    cases.extend(cases_of(
        "tube, all motions fixed",
        &tube_on_soil(held_at_base, 1.0),
        1,
        &Values {
            mass_kg: "29149.895755",
            subdyn: "4.955014654 4.955014654 28.3729846735 28.3729846735 40.3615271641",
            exact: "4.9547585555 4.9547585555 28.3385702386 28.3385702386 40.1033696187",
            held: "27.863232002 27.863232002 67.1904 67.1904",
        },
    ));
    let mut rigid = cases_of(
        "nearly rigid tube on soil",
        &tube_on_soil([false; 6], 1e5),
        1,
        &Values {
            mass_kg: "33149.895755",
            subdyn: "1.4453200997 1.4991939174 13.3643711571 13.7632541264 14.1464389291 25.0359099769",
            exact: "1.4453206599 1.4991945659 13.3644054555 13.7632884325 14.1464414168 25.0359494773",
            held: "",
        },
    );
    // Nodal coordinates lose digits where a tube is 10⁵ times too stiff.
    rigid[0].runs[0].allowance = 3e-8;
    rigid[0].remark = "Nodal coordinates lose digits where members are 100 000 times too stiff.";
    rigid[1].runs[0].allowance = 1e-5;
    rigid[1].remark = "The expected values are those of a rigid body.";
    rigid[1].source = "eigenvalues of a 6×6 matrix";
    cases.extend(rigid);
    for case in &mut cases {
        if case
            .expected
            .iter()
            .any(|expected| expected.decimals < 6 && expected.value > 50.0)
        {
            case.remark = ABOVE;
        }
    }
    cases
}

fn with_joints() -> Vec<Case> {
    let pin = |axis, stiffness_n_m_per_rad| JointKind::Pin {
        axis,
        stiffness_n_m_per_rad,
    };
    let universal = |stiffness_n_m_per_rad| JointKind::Universal {
        stiffness_n_m_per_rad,
    };
    let ball = |stiffness_n_m_per_rad| JointKind::Ball {
        stiffness_n_m_per_rad,
    };
    let mut cases = mechanism(
        "pin",
        pin([0.0, 1.0, 0.0], 0.0),
        "1",
        "4.954463669 13.3139980726 28.2876253339",
        "4.9547585557 13.3197094575 28.3385702347",
        "18.8972564211 27.8632320019 67.1903692859 67.1903692859",
    );
    cases.extend(mechanism(
        "universal joint",
        universal(0.0),
        "2",
        "13.3139980742 13.3139980742 40.1678215206",
        "13.3197094567 13.3197094567 40.103369485",
        "18.8972564211 18.8972564211 67.1903692859 67.1903692859 80.2067392375",
    ));
    cases.extend(mechanism(
        "ball joint",
        ball(0.0),
        "3",
        "13.3139980706 13.3139980706 64.7563331502",
        "13.3197094599 13.3197094599 64.65243",
        "18.8972564211 18.8972564211 67.1903692859 67.1903692859 80.2067392375 80.2067392375",
    ));
    cases.extend(cases_of(
        "pin with a spring",
        &jointed(pin([1.0, 2.0, 0.0], 2e8)),
        2,
        &Values {
            mass_kg: "29149.895755",
            subdyn: "2.7236804441 4.954463669 15.0109611703 28.2876253572",
            exact: "2.7237300737 4.9547585555 15.0191320804 28.3385702385",
            held: "19.8764036863 27.8632320019",
        },
    ));
    cases.extend(cases_of(
        "bent universal joint with springs",
        &bent(universal(2e8), false),
        2,
        &Values {
            mass_kg: "31007.979751",
            subdyn: "2.8524548805 2.8898192712 10.215500353 11.7842334168",
            exact: "2.8525120256 2.8898787324 10.2186162266 11.7880714903",
            held: "17.33993902 36.9058031649 60.3308012724",
        },
    ));
    cases.extend(cases_of(
        "ball joint of three members with springs",
        &bent(ball(1e8), true),
        2,
        &Values {
            mass_kg: "46974.035205",
            subdyn: "2.8588219443 3.0971522822 13.9175515653 17.8972034698",
            exact: "2.8588794412 3.09722389 13.9236576179 17.891423308",
            held: "17.4053988798 44.2246330136 57.0510906945",
        },
    ));
    cases
}

/// Two tubes with a joint without springs: some motions have no stiffness.
fn mechanism(
    name: &str,
    joint: JointKind,
    still: &str,
    subdyn: &'static str,
    exact: &'static str,
    held: &'static str,
) -> Vec<Case> {
    let frame = jointed(joint);
    let values = Values {
        mass_kg: "29149.895755",
        subdyn,
        exact,
        held,
    };
    let mut cases = cases_of(name, &frame, 2, &values);
    let places: usize = still.parse().expect("a number of the manual");
    for case in &mut cases[..2] {
        for expected in &mut case.expected {
            if let Quantity::Lowest(place) = &mut expected.quantity {
                *place += places;
            }
        }
        let still = Expected::parsed(Quantity::MotionsWithoutStiffness, still);
        case.expected.insert(0, still);
        case.runs[0].allowance = DIGITS_OF_MECHANISMS;
        case.remark = "A mechanism. The frequencies are where the number of modes below rises.";
    }
    cases
}

fn with_other_members() -> Vec<Case> {
    let mut cases = cases_of(
        "mast with four cables",
        &guyed(true),
        2,
        &Values {
            mass_kg: "9154.668299",
            subdyn: "4.7605144034 5.0813848976 12.2897899103 12.2963761635",
            exact: "4.7603075505 5.0811309987 12.283452664 12.2899814577",
            held: "12.4460236124 12.5081536582",
        },
    );
    cases.extend(cases_of(
        "mast with four cables, without their stiffness across the axis (SubDyn 5.0)",
        &guyed(false),
        2,
        &Values {
            mass_kg: "",
            subdyn: "4.5716376138 4.9126794463 12.2863342372 12.2928949974",
            exact: "4.5714559335 4.912450871 12.280027084 12.2865305583",
            held: "12.411920126 12.4758002241",
        },
    ));
    for (name, has_link) in [
        ("body on a rigid link", true),
        ("body away from its joint", false),
    ] {
        cases.extend(cases_of(
            name,
            &with_body(has_link),
            2,
            &Values {
                mass_kg: "37149.895755",
                subdyn: "4.2559198576 4.302602092 16.3224136144 24.2095910807",
                exact: "4.2561714876 4.3028685453 16.3231822877 24.2405151366",
                held: "19.3822694935 22.3953585123",
            },
        ));
    }
    cases.extend(cases_of(
        "rigid links of 500 kg/m",
        &with_heavy_links(),
        2,
        &Values {
            mass_kg: "32808.208150",
            subdyn: "4.6126202921 4.647252119 21.7185463549 26.1194051916",
            exact: "4.6129349743 4.647579028 21.7227259498 26.1575972592",
            held: "24.0374575119 24.9117819032",
        },
    ));
    cases.extend(cases_of(
        "spring between two tubes",
        &with_spring(),
        3,
        &Values {
            mass_kg: "27692.400967",
            subdyn: "2.395018396 2.9885324791 9.7451728485 11.5259083154",
            exact: "2.3950537243 2.988593752 9.7448847613 11.5271945025",
            held: "21.1793026433 21.5919283065",
        },
    ));
    cases
}

/// Monopiles and the jacket.
fn public() -> Vec<Case> {
    let piles = [
        (
            "OC3 monopile",
            oc3_monopile(false),
            3,
            "285515.17526",
            "6.0726862 6.0726862 25.7255461 28.3203390 28.3203390 41.4732977",
            "6.0800033006 6.0800033006 25.6929235025 28.9566151812 28.9566151812 41.4207054100",
            "27.2106206103 27.2106206103",
        ),
        (
            "IEA-15 monopile",
            iea_15_monopile(),
            1,
            "623924.67734",
            "3.7192968241 3.7192968241 15.6462303316 17.7803892287 17.7803892287 24.8991820724",
            "3.7239385422 3.7239385422 15.6360356336 18.1931476459 18.1931476459 24.8828404450",
            "19.5421781221 19.5421781221",
        ),
        (
            "OC4 jacket",
            jacket(false, false),
            2,
            "673882.73468",
            "2.7554765604 2.7554765604 5.0043390289 5.4133305766 7.6342582744 7.6342582744",
            "2.7551948344 2.7551948344 5.0027865538 5.4097103739 7.621246 7.621246",
            "7.326523 7.326523 8.334309 8.96010",
        ),
    ];
    let piles =
        piles
            .into_iter()
            .flat_map(|(name, frame, divisions, mass_kg, subdyn, exact, held)| {
                let values = Values {
                    mass_kg,
                    subdyn,
                    exact,
                    held: "",
                };
                let mut free = frame.clone();
                free.transition = None;
                let mut cases = cases_of(name, &free, 0, &values);
                if let Subject::Frame(_, recipe) = &mut cases[0].subject {
                    *recipe = Some(FrameRecipe::Subdyn { divisions });
                }
                // Degrees above it change no digit.
                for case in &mut cases[1..] {
                    if let Subject::Frame(_, recipe) = &mut case.subject {
                        *recipe = Some(EXACT);
                    }
                }
                cases[1].runs[0].allowance = 1e-9;
                let mut held_frame = frame;
                if let Some(transition) = &mut held_frame.transition {
                    transition.is_held = true;
                }
                let subject = Subject::Frame(Box::new(held_frame), Some(EXACT));
                let name = format!("{name}, transition piece held");
                cases.push(case(name, ABOVE, subject, Expected::lowest(held), DIGITS));
                cases
            });
    piles.collect()
}

/// The stiffness of frames reduced to the transition piece, as SubDyn computes it.
fn reduced() -> Vec<Case> {
    let at_top = |frame, joint| {
        let mut frame = with_top_held(frame, joint);
        if let Some(transition) = &mut frame.transition {
            transition.is_held = false;
        }
        frame
    };
    let rows = [
        (
            "tube on soil",
            at_top(tube_on_soil([false; 6], 1.0), 1),
            "5389585.1966 5681374.2623 224721329.06 2281414707.0 2237021067.3 356846836.09 -",
            DIGITS,
        ),
        (
            "mast with four cables, without their stiffness across the axis",
            at_top(guyed(false), 2),
            "3439592.4026 3833296.0471 522600260.5 184802733.75 180451025.95 - -",
            DIGITS,
        ),
        (
            "OC3 monopile",
            oc3_monopile(false),
            "353036500 - 7837619000 - 114004700000 26603170000 -5295565000",
            2e-7,
        ),
        (
            "OC4 jacket",
            jacket(false, false),
            "88193490.442 - 1992615816.0 102484386390 - 8457464320.4 -2231228690.57",
            1e-9,
        ),
    ];
    let rows = rows.into_iter().map(|(name, frame, digits, allowance)| {
        let subject = Subject::Frame(Box::new(frame), None);
        let name = format!("{name}, stiffness at its top");
        let remark = "The internal motions are condensed statically (Guyan 1965). For the mast the source uses the stiffness without tension in the cables.";
        case(name, remark, subject, stiffness(digits), allowance)
    });
    rows.collect()
}
