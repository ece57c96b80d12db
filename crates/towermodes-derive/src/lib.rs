//! `#[derive(Inputs)]` for the tables of a tower file, inside the crate `towermodes`.
//!
//! Each field is one value of the table, `#[input(EXPRESSION)]`, several values of a type of its
//! own, `#[inputs]`, or a list of other tables, `#[tables]`. The expression is a constant of type
//! `Input`: the compiler checks it.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Data, DeriveInput, Error, Field, Fields, Ident, Meta};

/// Implements `towermodes::inputs::Inputs` for a struct with named fields.
#[proc_macro_derive(Inputs, attributes(input, inputs, tables))]
pub fn derive_inputs(item: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let item = syn::parse_macro_input!(item as DeriveInput);
    let code = inputs(&item);
    code.unwrap_or_else(Error::into_compile_error).into()
}

fn inputs(item: &DeriveInput) -> syn::Result<TokenStream> {
    let Data::Struct(data) = &item.data else {
        return Err(Error::new_spanned(&item.ident, "Inputs is for structs"));
    };
    let Fields::Named(fields) = &data.fields else {
        return Err(Error::new_spanned(&item.ident, "the fields have no names"));
    };
    let values: Vec<Value> = fields.named.iter().map(value).collect::<Result<_, _>>()?;
    let statics = values.iter().map(Value::definition);
    let (blanks, visits) = (
        values.iter().map(Value::blank),
        values.iter().map(Value::visit),
    );
    let (updates, idles) = (
        values.iter().map(Value::update),
        values.iter().map(Value::idle),
    );
    let name = &item.ident;
    Ok(quote! {
        const _: () = {
            #(#statics)*
            impl crate::inputs::Inputs for #name {
                fn blank() -> Self { Self { #(#blanks)* } }
                fn visit(&self, each: &mut dyn FnMut(&'static crate::inputs::Input, crate::inputs::Given)) {
                    #(#visits)*
                }
                fn update(
                    &mut self,
                    each: &mut dyn FnMut(&'static crate::inputs::Input, crate::inputs::Given) -> crate::inputs::Given,
                ) {
                    #(#updates)*
                }
                fn idle(&self, each: &mut dyn FnMut(&'static crate::inputs::Input, crate::inputs::Given)) {
                    #(#idles)*
                }
            }
        };
    })
}

/// What a field is.
struct Value<'a> {
    field: &'a Ident,
    content: Content,
}

/// What a field holds.
enum Content {
    /// A value, described by this constant.
    Value(TokenStream),
    /// Values of its own.
    Values,
    /// Other tables.
    Tables,
}

fn value(field: &Field) -> syn::Result<Value<'_>> {
    let missing = "which value of the tower file is it? #[input(…)], #[inputs] for several, or #[tables] for other tables";
    let named = field.ident.as_ref();
    let ident = named.ok_or_else(|| Error::new_spanned(field, missing))?;
    for attribute in &field.attrs {
        let content = match &attribute.meta {
            Meta::Path(path) if path.is_ident("inputs") => Content::Values,
            Meta::Path(path) if path.is_ident("tables") => Content::Tables,
            Meta::List(list) if list.path.is_ident("input") => Content::Value(list.tokens.clone()),
            _ => continue,
        };
        let field = ident;
        return Ok(Value { field, content });
    }
    Err(Error::new_spanned(field, missing))
}

impl Value<'_> {
    /// The name of the static that describes it.
    fn of(&self) -> Ident {
        format_ident!("INPUT_{}", self.field.to_string().to_uppercase())
    }

    fn definition(&self) -> Option<TokenStream> {
        let name = self.of();
        match &self.content {
            Content::Value(input) => Some(quote! { static #name: crate::inputs::Input = #input; }),
            Content::Values | Content::Tables => None,
        }
    }

    fn blank(&self) -> TokenStream {
        let (field, input) = (self.field, self.of());
        match self.content {
            Content::Value(_) => quote! { #field: crate::inputs::Value::blank(&#input), },
            Content::Values => quote! { #field: crate::inputs::Inputs::blank(), },
            Content::Tables => quote! { #field: Default::default(), },
        }
    }

    fn visit(&self) -> Option<TokenStream> {
        let (field, input) = (self.field, self.of());
        match self.content {
            Content::Value(_) => Some(quote! {
                each(&#input, crate::inputs::Value::given(&self.#field));
            }),
            Content::Values => Some(quote! { crate::inputs::Inputs::visit(&self.#field, each); }),
            Content::Tables => None,
        }
    }

    fn update(&self) -> Option<TokenStream> {
        let (field, input) = (self.field, self.of());
        match self.content {
            Content::Value(_) => Some(quote! {
                let given = each(&#input, crate::inputs::Value::given(&self.#field));
                crate::inputs::Value::set(&mut self.#field, given);
            }),
            Content::Values => Some(quote! {
                crate::inputs::Inputs::update(&mut self.#field, each);
            }),
            Content::Tables => None,
        }
    }

    fn idle(&self) -> Option<TokenStream> {
        let field = self.field;
        match self.content {
            Content::Values => Some(quote! { crate::inputs::Inputs::idle(&self.#field, each); }),
            Content::Value(_) | Content::Tables => None,
        }
    }
}
