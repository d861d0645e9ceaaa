// Forms of the parameters of every model: exact values, units, defaults and refusals.

#include "app/gui/workbench/parameter_form.h"

#include <set>
#include <stdexcept>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSlider>
#include <gtest/gtest.h>

#include "app/gui/base/parameter_words.h"
#include "app/gui/base/settings.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {
namespace {

/// Away from the default, with more digits than a field shows.
ParameterValues odd_values(const std::vector<Parameter>& parameters) {
  ParameterValues values{};
  for (const Parameter& parameter : parameters) {
    if (parameter.kind == ParameterKind::choice) {
      values[parameter.name] = parameter.choices.back();
    } else if (parameter.kind == ParameterKind::integer) {
      values[parameter.name] = parameter.maximum;
    } else {
      values[parameter.name] =
          parameter.minimum + 0.123456789012345 * (parameter.maximum - parameter.minimum);
    }
  }
  return values;
}

void type(QDoubleSpinBox& field, const char* text) {
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, text);
  QTest::keyClick(&field, Qt::Key_Return);
}

TEST(ParameterForm, GivesBackExactlyWhatItWasGivenForEveryModel) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    ParameterForm form(model.declaration.parameters);
    EXPECT_EQ(form.values(), complete_values(model.declaration, {})) << model.declaration.id;
    EXPECT_TRUE(form.given().empty());
    const ParameterValues odd = odd_values(model.declaration.parameters);
    form.set_values(odd);
    EXPECT_EQ(form.values(), odd) << model.declaration.id;
  }
}

TEST(ParameterForm, HasAControlWithMeaningForEveryParameterOfEveryModel) {
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) {
    const ParameterForm form(model.declaration.parameters);
    for (const Parameter& parameter : model.declaration.parameters) {
      const auto* control = form.findChild<QWidget*>(QString::fromStdString(parameter.name));
      ASSERT_NE(control, nullptr) << parameter.name;
      EXPECT_TRUE(control->toolTip().contains(
          QString::fromStdString(parameter.meaning.english()).toHtmlEscaped()))
          << parameter.name;
    }
  }
}

TEST(ParameterForm, DescribesAParameterOnItsSliderAsOnItsField) {
  const ParameterForm form(texture_recipe_parameters(), FormStyle::sliders);
  const QString described = form.findChild<QDoubleSpinBox*>("gamma_low")->toolTip();
  EXPECT_FALSE(described.isEmpty());
  EXPECT_EQ(form.findChild<QSlider*>("slider_gamma_low")->toolTip(), described);
}

TEST(ParameterForm, KeepsEveryDigitOfAValueThatIsOnlyLookedAt) {
  ParameterForm form(texture_recipe_parameters());
  form.set_values({{"rms_m", 0.000123456789012345}});
  form.show();
  auto* field = form.findChild<QDoubleSpinBox*>("rms_m");
  field->setFocus();
  QTest::keyClick(field, Qt::Key_Return);  // has the text read again
  EXPECT_EQ(number_of(form.values(), "rms_m"), 0.000123456789012345);
}

TEST(ParameterForm, ReadsMicrometresAsTheExactDecimalInMetres) {
  ParameterForm form(texture_recipe_parameters());
  form.show();
  auto* field = form.findChild<QDoubleSpinBox*>("rms_m");
  EXPECT_EQ(field->text(), QString::fromUtf8("100 µm"));
  QSignalSpy edited(&form, &ParameterForm::edited);
  type(*field, "110.1");  // 110.1 times 1e-6 is another number
  EXPECT_EQ(edited.count(), 1);
  EXPECT_EQ(number_of(form.values(), "rms_m"), 110.1e-6);
}

TEST(ParameterForm, MarksADefaultAndGoesBackToIt) {
  ParameterForm form(texture_recipe_parameters(), FormStyle::sliders);
  form.show();
  auto* reset = form.findChild<QPushButton*>("reset_gamma_low");
  EXPECT_EQ(reset->text(), "default");
  EXPECT_FALSE(reset->isEnabled());
  form.findChild<QSlider*>("slider_gamma_low")->setValue(900);
  EXPECT_NE(number_of(form.values(), "gamma_low"), 0.5);
  EXPECT_EQ(form.given().size(), 1U);
  EXPECT_TRUE(reset->isEnabled());
  QTest::mouseClick(reset, Qt::LeftButton);
  EXPECT_EQ(number_of(form.values(), "gamma_low"), 0.5);
  EXPECT_TRUE(form.given().empty());
}

TEST(ParameterForm, LetsWhatStandsAtItsDefaultFollowANewDefault) {
  const ModelRegistry registry = built_in_models();
  ParameterForm form(registry.find("stochastic")->declaration.parameters);
  form.set_values({{"noise_rate_Hz", 500.0}});
  form.set_defaults({{"noise_sd_N", 0.2}, {"noise_rate_Hz", 2000.0}});
  EXPECT_EQ(number_of(form.values(), "noise_sd_N"), 0.2);
  EXPECT_EQ(number_of(form.values(), "noise_rate_Hz"), 500.0);
  EXPECT_EQ(form.given().size(), 1U);
}

TEST(ParameterForm, RefusesWhatTheDeclarationRefusesAndKeepsWhatItHad) {
  ParameterForm form(texture_recipe_parameters());
  EXPECT_THROW(form.set_values({{"rms_m", -1.0}}), std::invalid_argument);
  EXPECT_EQ(number_of(form.values(), "rms_m"), 1e-4);
}

TEST(ParameterForm, ChoosesByTheKeyboard) {
  ParameterForm form(texture_recipe_parameters());
  form.show();
  auto* list = form.findChild<QComboBox*>("histogram");
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_EQ(choice_of(form.values(), "histogram"), "equalize");
}

/// All names that windows show, in their language.
QStringList names_in(const QString& language) {
  apply_language(language);
  std::vector<Parameter> parameters = texture_recipe_parameters();
  const auto add = [&parameters](const std::vector<Parameter>& declared) {
    parameters.insert(parameters.end(), declared.begin(), declared.end());
  };
  const ModelRegistry registry = built_in_models();
  add(canvas_parameters());
  for (const ForceModel& model : registry.models()) add(model.declaration.parameters);
  QStringList names{};
  for (const SurfaceDeclaration& surface : synthetic_surfaces()) {
    add(surface.parameters);
    names.append(surface_name(surface.kind));
  }
  for (const Parameter& parameter : parameters) {
    names.append(caption_of(parameter));
    if (parameter.name == "method") continue;  // authors
    for (const std::string& choice : parameter.choices) {
      names.append(choice_name(parameter, choice));
    }
  }
  apply_language("en");
  return names;
}

TEST(ParameterWords, AreGermanInGermanWindowsForEveryDeclaredParameter) {
  const QStringList english = names_in("en");
  const QStringList german = names_in("de");
  ASSERT_EQ(english.size(), german.size());
  const std::set<QString> same{"Amplitude", "Bits",   "Dahl",   "Exponent", "Gradient",
                               "Index",     "LuGre",  "Linear", "Maximum",  "Original",
                               "Proxy",     "Relief", "Tau"};
  for (qsizetype i = 0; i < english.size(); ++i) {
    if (same.contains(english[i])) continue;
    EXPECT_NE(german[i].toStdString(), english[i].toStdString());
  }
}

TEST(ParameterWords, NameOneOfSeveralAndStateTheWordInFiles) {
  apply_language("de");
  const Parameter wave = number_parameter("sine_amplitude_2_m", "m", 0.0, 1.0, 0.0, "");
  EXPECT_EQ(caption_of(wave), "Sinusamplitude 2");
  const Parameter damping = number_parameter("friction_damping_N_s_per_m", "N s/m", 0, 1, 0, "");
  EXPECT_EQ(caption_of(damping), "Reibung, Dämpfung");
  const Parameter law = choice_parameter("law", {"corrected", "literal"}, "");
  EXPECT_EQ(choice_with_word(law, "literal"), "Wörtlich (literal)");
  EXPECT_EQ(choice_name(law, "literal"), "Wörtlich");
  EXPECT_EQ(surface_name("sinusoid"), "Sinus");
  apply_language("en");
  EXPECT_EQ(choice_with_word(law, "literal"), "Literal");
  EXPECT_EQ(surface_name("sinusoid"), "Sinusoid");
  const Parameter of_plugin = number_parameter("odd_gain_N", "N", 0.0, 1.0, 0.0, "");
  EXPECT_EQ(caption_of(of_plugin), "Odd gain") << "a plug-in's";
}

}  // namespace
}  // namespace asperity
