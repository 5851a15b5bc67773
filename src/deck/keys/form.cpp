#include "src/deck/keys/form.hpp"

namespace percuss {

Form number_form(Range range) {
  Form form{Form::Kind::number};
  form.range = std::move(range);
  return form;
}

Form word_form(std::vector<std::string> words) {
  Form form{Form::Kind::word};
  form.words = std::move(words);
  return form;
}

Form list_form(Form item, std::size_t least) {
  Form form{Form::Kind::list};
  form.inner.push_back(std::move(item));
  form.least = least;
  return form;
}

Form tuple_form(std::vector<Form> items) {
  Form form{Form::Kind::tuple};
  form.inner = std::move(items);
  return form;
}

Form any_form(std::vector<Form> choices) {
  Form form{Form::Kind::any_of};
  form.inner = std::move(choices);
  return form;
}

Form map_form(std::vector<FormKey> keys) {
  Form form{Form::Kind::map};
  form.keys = std::move(keys);
  return form;
}

}  // namespace percuss
