/// Sentences for people that other programs can show in another language.
#pragma once

#include <concepts>
#include <exception>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rtcore {

/// A form, which is English, with what stands in its places {0}, {1}, ... The form is also the key by which
/// its translation is found, so it stands in the code that says it, and nowhere else. Without a form it is a
/// text that is the same in every language: a name, a number, what the system said.
class Sentence {
  public:
    Sentence() = default;
    Sentence(const char* form) : text_(form), form_(true) {}
    Sentence(std::string text) : text_(std::move(text)) {}
    Sentence(std::string_view text) : text_(text) {}
    Sentence(std::integral auto number) : text_(std::to_string(number)) {}
    /// {i} stands for the i-th of `arguments`, and for itself where there is none.
    Sentence(const char* form, std::vector<Sentence> arguments)
        : text_(form), form_(true), arguments_(std::move(arguments)) {}

    bool isForm() const { return form_; }
    const std::string& text() const { return text_; } ///< the form, or all of the text
    const std::vector<Sentence>& arguments() const { return arguments_; }
    std::string english() const;
    bool empty() const { return text_.empty(); }
    friend bool operator==(const Sentence&, const Sentence&) = default;

  private:
    std::string text_;
    bool form_ = false;
    std::vector<Sentence> arguments_;
};

/// Marks a form that is said elsewhere, for those who look for all of them (scripts/sentences.py).
constexpr const char* form(const char* text) { return text; }

/// A form with texts, whole numbers and further sentences in its places.
template <typename... Arguments>
Sentence say(const char* words, Arguments&&... arguments) {
    return Sentence(words, std::vector<Sentence>{Sentence(std::forward<Arguments>(arguments))...});
}

/// The texts in the places of `form`, in their order in it, where those make `text`; none of them is empty.
std::optional<std::vector<std::string_view>> placesIn(std::string_view text, std::string_view form);

/// The first of `forms` that `text` may have been made of, and what stands in its places, which is read in
/// the same way; else the text itself.
Sentence readAs(std::string_view text, std::span<const char* const> forms);

/// Parts of exceptions: what() in a form that can be translated.
class Worded {
  public:
    explicit Worded(Sentence sentence) : sentence_(std::move(sentence)) {}
    const Sentence& sentence() const { return sentence_; }

  protected:
    ~Worded() = default;

  private:
    Sentence sentence_;
};

/// std::runtime_error for people: something cannot be done now.
class Refusal : public std::runtime_error, public Worded {
  public:
    explicit Refusal(const Sentence& why) : std::runtime_error(why.english()), Worded(why) {}
};

/// std::invalid_argument for people: a value that cannot be taken.
class BadValue : public std::invalid_argument, public Worded {
  public:
    explicit BadValue(const Sentence& why) : std::invalid_argument(why.english()), Worded(why) {}
};

/// The sentence that `error` holds; its what() where it is not Worded.
Sentence sentenceOf(const std::exception& error);

} // namespace rtcore
