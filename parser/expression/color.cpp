// COLOUR (specification chapters 10 §9.1 and 11 §1.1).
#include <cmath>

#include "parser/expression/recorder.hpp"

namespace lute {

namespace {

struct MainForm {
  int components;   // the context count of its expression
  bool srgb;
  bool fourth_is_transmit = false;
};

std::optional<MainForm> main_form(Word word) {
  switch (word) {
    case Word::kRgb: return MainForm{3, false};
    case Word::kRgbf: return MainForm{4, false};
    case Word::kRgbt: return MainForm{4, false, true};
    case Word::kRgbft: return MainForm{5, false};
    case Word::kSrgb: return MainForm{3, true};
    case Word::kSrgbf: return MainForm{4, true};
    case Word::kSrgbt: return MainForm{4, true, true};
    case Word::kSrgbft: return MainForm{5, true};
    default: return std::nullopt;
  }
}

bool is_component(Word word) {
  switch (word) {
    case Word::kRed: case Word::kGreen: case Word::kBlue: case Word::kFilter: case Word::kTransmit: case Word::kAlpha: return true;
    default: return false;
  }
}

float decode_srgb(const Session& session, float c) {
  const float linear = c < 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  const GlobalSettings& settings = session.scene.settings;
  if (settings.gamma_mode == GammaMode::kPower && settings.assumed_gamma != 1) {
    return static_cast<float>(std::pow(static_cast<double>(linear), 1.0 / settings.assumed_gamma));
  }
  return settings.gamma_mode == GammaMode::kSrgb ? c : linear;
}

// A float fills all components of the context; what is missing else is zero.
Color color_of(Session& session, Number value, const MainForm& form) {
  if (value.count < form.components) value = promoted(session, value, form.components);
  if (form.components == 3 && value.count > 3) session.warn("Suspicious expression after rgb.", "suspicious-color");
  Color color = value.color();
  if (form.fourth_is_transmit && value.count == 4) {
    color.transmit = color.filter;
    color.filter = 0;
  }
  if (form.srgb) {
    if (!session.language.assumed_gamma_given) {
      session.fail("Cannot parse sRGB colors before assumed_gamma has been set.", "srgb");
    }
    color.rgb = {decode_srgb(session, color.rgb.r), decode_srgb(session, color.rgb.g), decode_srgb(session, color.rgb.b)};
  }
  return color;
}

void parse_component(Session& session, Color& color) {
  const Word word = session.stream.take().word();
  const auto value = static_cast<float>(promoted(session, evaluate(session, Level::kAdditive), 1).c[0]);
  switch (word) {
    case Word::kRed: color.rgb.r = value; break;
    case Word::kGreen: color.rgb.g = value; break;
    case Word::kBlue: color.rgb.b = value; break;
    case Word::kTransmit: color.transmit = value; break;
    case Word::kAlpha: session.warn("Keyword ALPHA discontinued. Use FILTER instead.", "alpha"); color.filter = value; break;
    default: color.filter = value; break;
  }
}

}  // namespace

bool starts_color(const Item& item) {
  const Word word = item.word();
  return word == Word::kColor || main_form(word) || is_component(word) || starts_number(item);
}

bool is_written_color(const Item& item) {
  const Number* const number = item.is(TokenKind::kIdentifier) ? item.slot->get_if<Number>() : nullptr;
  return number != nullptr ? number->count == 5 : starts_color(item) && !starts_number(item);
}

ColorValue parse_color(Session& session, int bare_components) {
  TokenStream& stream = session.stream;
  ColorValue result;
  result.empty = true;
  if (stream.peek().is(Word::kColor)) {
    stream.take();
    result.empty = false;
  }
  if (const auto form = main_form(stream.peek().word())) {
    stream.take();
    result.color = color_of(session, evaluate(session, Level::kFull), *form);
    result.empty = false;
  } else if (starts_number(stream.peek())) {
    const Number value = evaluate(session, Level::kFull);
    // Where only red, green and blue are wanted a float fills those alone; more components are accepted.
    result.color = (value.count < bare_components ? promoted(session, value, bare_components) : value).color();
    result.empty = false;
  }
  while (is_component(stream.peek().word())) {
    parse_component(session, result.color);
    result.empty = false;
  }
  return result;
}

}  // namespace lute
